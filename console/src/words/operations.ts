/** The operations of drawings in the language of the page. */

import { drawingWords } from "../app/drawingWords";
import type { OperationEntry } from "../wire/messages";
import { colours, operationLabels, operationTexts, operationWords } from "./german/operations";
import { language, type Table } from "./words";

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

const own = (table: Table, text: string): string =>
  language === "de" ? (table[text] ?? text) : text;

/** The name of an operation as a person reads it. */
export const operationTitle = ({ name }: Pick<OperationEntry, "name">): string =>
  (language === "de" && operationTexts[name]?.name) ||
  drawingWords(capital(name.replaceAll("-", " ")));

/** Description of what an operation does. */
export const operationDoc = ({ name, doc }: Pick<OperationEntry, "name" | "doc">): string =>
  (language === "de" && operationTexts[name]?.doc) || drawingWords(doc);

/** The label of a value, from the word before it: `lead-in=` is Lead in. */
export const operationLabel = (word: string): string =>
  own(operationLabels, drawingWords(capital(word.replaceAll("-", " "))));

/** A word that a value may be. */
export const operationWord = (word: string): string =>
  own({ ...colours, ...operationWords }, drawingWords(word));

/** The colour by which a layer is called. */
export const colourWords = (name: string): string => own(colours, name);

/** Texts of an operation without German words. */
export function untold({ name, variants }: OperationEntry): string[] {
  const parts = variants.flatMap((variant) => variant.parts);
  const labels = parts.map(({ lead }) => lead.replace(/[= ]+$/, "")).filter((lead) => lead !== "");
  const shown = labels.map((label) => drawingWords(capital(label.replaceAll("-", " "))));
  const words = parts.flatMap(({ value }) => (value && "words" in value ? value.words : []));
  return [
    ...(operationTexts[name] ? [] : [name]),
    ...shown.filter((label) => !operationLabels[label]),
    ...words.filter((word) => !operationWords[drawingWords(word)]),
  ];
}
