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

/** Translates a sentence; nothing where the table has none for it. */
export type Translate = (text: string) => string | undefined;

/** Reads a table once: sentences without places are looked up, the others compared in their order. */
export function translator(table: Table): Translate {
  const patterns = Object.entries(table)
    .filter(([said]) => /\{\d\}/.test(said))
    .map(([said, own]) => [patternOf(said), own] as const);
  const translate: Translate = (text) => {
    if (Object.hasOwn(table, text)) return table[text];
    for (const [pattern, own] of patterns) {
      const found = pattern.exec(text);
      if (!found) continue;
      // A sentence may stand in the place of another.
      const values = found.slice(1).map((value) => translate(value) ?? value);
      return own.replace(/\{(\d)\}/g, (_, at) => values[Number(at)] ?? "");
    }
    return undefined;
  };
  return translate;
}
