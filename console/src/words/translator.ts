/** Sentences of the server in another language, by a table with places for the values in them. */

import type { Table } from "./words";

const places = /\\\{(\d)\\\}/g;
const special = /[.*+?^${}()|[\]\\]/g;

/** A place takes something; one right behind another takes what follows a number, or nothing. */
const placeOf = (_: string, __: string, at: number, said: string): string =>
  said[at - 1] === "}" ? "((?!\\d).*?)" : "(.+?)";

/** A pattern of what the server says with something in its places, which stand in their order. */
const patternOf = (said: string): RegExp =>
  new RegExp(`^${said.replace(special, "\\$&").replace(places, placeOf)}$`, "s");

/** Signs of a sentence that always stand there; of two with the same, the one with more places comes first. */
const weight = (said: string): number =>
  100 * said.replace(/\{\d\}/g, "").length + (said.match(/\{\d\}/g) ?? []).length;

/** Sentences that are kept once they are translated; a page hears the same ones again and again. */
const keptSentences = 2000;

/** Translates a sentence; nothing where the table has none for it. */
export type Translate = (text: string) => string | undefined;

/** Signs between sentences that the server puts together; a way to mend stands in brackets. */
const joints = [" (", "; ", ": "];

/** The places of a sign in a text, the last first. */
function placesOf(sign: string, text: string): number[] {
  const found: number[] = [];
  for (let at = text.lastIndexOf(sign); at > 0; at = text.lastIndexOf(sign, at - 1)) found.push(at);
  return found;
}

/**
 * Reads a table once: sentences without places are looked up, the others compared. Of several that fit, the one
 * counts that says most by itself. Of sentences put together each is translated that is known.
 */
export function translator(table: Table): Translate {
  const patterns = Object.entries(table)
    .filter(([said]) => /\{\d\}/.test(said))
    .sort(([a], [b]) => weight(b) - weight(a))
    .map(([said, own]) => [patternOf(said), own] as const);
  const kept = new Map<string, string | undefined>();
  const orSame = (text: string): string => translate(text) ?? text;
  const compare: Translate = (text) => {
    for (const [pattern, own] of patterns) {
      const found = pattern.exec(text);
      if (!found) continue;
      // A sentence may stand in the place of another.
      const values = found.slice(1).map(orSame);
      return own.replace(/\{(\d)\}/g, (_, at) => values[Number(at)] ?? "");
    }
    return undefined;
  };
  /** Translates the rest behind a sentence, with the sign between them: a part that the table has so, or another sentence. */
  const behind = (sign: string, text: string): string => {
    const end = sign === " (" && text.endsWith(")") ? -1 : undefined;
    const rest = text.slice(sign.length, end);
    return translate(text) ?? sign + orSame(rest) + (end === undefined ? "" : ")");
  };
  const apart: Translate = (text) => {
    for (const sign of joints) {
      for (const at of placesOf(sign, text)) {
        const first = translate(text.slice(0, at));
        if (first !== undefined) return first + behind(sign, text.slice(at));
      }
    }
    // Before a sentence may stand a name: of a file, of a controller.
    const at = text.indexOf(": ") + 2;
    const said = at > 2 ? translate(text.slice(at)) : undefined;
    return said === undefined ? undefined : text.slice(0, at) + said;
  };
  const translate: Translate = (text) => {
    if (Object.hasOwn(table, text)) return table[text];
    if (!kept.has(text)) {
      if (kept.size >= keptSentences) kept.clear();
      kept.set(text, compare(text) ?? apart(text));
    }
    return kept.get(text);
  };
  return translate;
}
