/** Sentences of the server in the language of the page, as far as its table has them; the others stay as they are said. */

import { serverSentences } from "./german/server";
import { language } from "./words";

const places = /\\\{(\d)\\\}/g;
const special = /[.*+?^${}()|[\]\\]/g;

/** A pattern of what the server says with something in its places, which stand in their order. */
const patternOf = (said: string): RegExp =>
  new RegExp(`^${said.replace(special, "\\$&").replace(places, "(.+?)")}$`, "s");

const patterns = Object.entries(serverSentences).map(
  ([said, german]) => [patternOf(said), german] as const,
);

/** A sentence of the server in German. */
export function inGerman(text: string): string {
  for (const [pattern, german] of patterns) {
    const found = pattern.exec(text);
    if (found) return german.replace(/\{(\d)\}/g, (_, at) => found[Number(at) + 1] ?? "");
  }
  return text;
}

/** A sentence of the server in the language of the page. */
export const serverWords = (text: string): string => (language === "de" ? inGerman(text) : text);
