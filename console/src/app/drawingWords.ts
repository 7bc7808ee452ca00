/** Sentences of the server about drawings, in the words of the page. */

import { serverWords } from "../words/server";

/** The page's words for those of the operations and the Profiler. */
const inField: readonly (readonly [RegExp, string])[] = [
  [/\bgroup(s?)\b/g, "layer$1"],
  [/\bGroup(s?)\b/g, "Layer$1"],
  [/\btag(s?)\b/g, "tab$1"],
  [/\bTag(s?)\b/g, "Tab$1"],
  [/\bthru\b/g, "through"],
  [/\bThru\b/g, "Through"],
];

/** A refusal as a person reads it: without the number, the words and the grammar of the clause that was sent. */
export const withoutGrammar = (text: string): string =>
  text.replace(/^clause \d+(?: `[^`]*`)?: /i, "").replace(/; write `[^`]*`$/, "");

/** A sentence or a name about a drawing: Layer, Tab and Through, and nothing of how operations are written. */
export function drawingWords(text: string): string {
  const plain = withoutGrammar(text);
  const own = serverWords(plain);
  return own === plain ? inField.reduce((said, [from, to]) => said.replace(from, to), plain) : own;
}
