/** The form of an operation as values: what is entered, what is wrong with it, the clause it makes. */

import type { LengthUnit } from "../../units/quantity";
import type { OperationEntry, OperationPart, OperationValue } from "../../wire/messages";
import { operationLabel } from "../../words/operations";
import { t } from "../../words/words";
import { isWrong, type Read, readAngle, readLength, readNumber } from "../entry";
import { num } from "../tools/tool";

/** Entry for each part; a word alone is `on` or blank. */
export type Entries = readonly string[];

export interface Given {
  /** In which lengths are typed. */
  readonly unit: LengthUnit;
  readonly selected: readonly number[];
}

/** First entries of a form: shapes that are selected, and words that are usual. */
export const firstEntries = (parts: readonly OperationPart[], given: Given): Entries =>
  parts.map((part) => firstEntry(part, given));

function firstEntry({ value, optional }: OperationPart, { selected }: Given): string {
  switch (value?.is) {
    case "shape":
      return String(selected[0] ?? "");
    case "shapes":
      return selected.join(",");
    case "words":
      return optional ? "" : (value.words[0] ?? "");
    case "group":
      return optional ? "" : "black";
    case undefined:
      return optional ? "" : "on";
    default:
      return "";
  }
}

const titles: Record<string, string> = {
  D: t("Diameter"),
  MM: t("Length"),
  Z: t("Height"),
  B: t("Bulge"),
  N: t("Number"),
};

const named: Partial<Record<OperationValue["is"], string>> = {
  pair: t("Place"),
  vertex: t("Vertices"),
  triple: t("Places"),
  arc: t("Radius, angle"),
  grid: t("Rows x columns"),
  shape: t("Shape"),
  shapes: t("Shapes"),
  group: t("Layer"),
  groups: t("Layers"),
  words: t("Which"),
  file: t("File"),
  text: t("Words"),
};

function nameOf(value: OperationValue | null): string {
  if (value?.is === "length" || value?.is === "number") {
    return titles[value.name] ?? operationLabel(value.name.toLowerCase());
  }
  return (value && named[value.is]) ?? "";
}

/** Labels of the fields; the same words twice are counted. */
export function labelsOf(parts: readonly OperationPart[]): string[] {
  const found: string[] = [];
  for (const { lead, value } of parts) {
    const word = lead.replace(/[= ]+$/, "");
    const plain = word === "" ? nameOf(value) : operationLabel(word);
    const before = found.filter((label) => label.replace(/ \d+$/, "") === plain).length;
    found.push(before > 0 ? `${plain} ${before + 1}` : plain);
  }
  return found;
}

/** The way of an operation as a person reads it: what has to be said. */
export function wayOf(parts: readonly OperationPart[]): string {
  const labels = labelsOf(parts);
  const said = labels.filter((_, n) => !parts[n]?.optional);
  return (said.length > 0 ? said : labels).join(", ");
}

/** An example of what may be entered. */
export function exampleOf({ value, repeats }: OperationPart): string {
  const one: Partial<Record<OperationValue["is"], string>> = {
    pair: "x,y",
    vertex: "x,y or x,y,bulge",
    triple: "x,y,z",
    arc: "5,90",
    grid: "2x3",
    shape: "1",
    shapes: "1,3-5",
    groups: "red,black",
    file: "part.dxf",
  };
  if (value?.is === "wordsOr") return t("{0}, or a number", value.words.join(t(" or ")));
  const example = (value && one[value.is]) ?? "";
  return repeats && value ? t("{0} …, blanks between", example) : example;
}

/** A clause, or what is wrong with the parts, by their places. */
export type Made = { readonly clause: string } | { readonly wrong: ReadonlyMap<number, string> };

export function clauseOf(
  { name }: Pick<OperationEntry, "name">,
  parts: readonly OperationPart[],
  entries: Entries,
  { unit }: Given,
): Made {
  const wrong = new Map<number, string>();
  const words = parts.flatMap((part, n) => {
    const read = said(part, (entries[n] ?? "").trim(), unit);
    if (!isWrong(read)) return read.value;
    wrong.set(n, read.wrong);
    return [];
  });
  return wrong.size > 0 ? { wrong } : { clause: [name, ...words].join(" ") };
}

/** The words of a part; none for one that is left out. */
function said(
  { lead, value, optional, repeats }: OperationPart,
  text: string,
  unit: LengthUnit,
): Read<string[]> {
  if (text === "") return optional ? { value: [] } : { wrong: t("This has to be given.") };
  if (!value) return { value: [lead] };
  const pieces = repeats ? text.split(/\s+/) : [text];
  const found: string[] = [];
  for (const piece of pieces) {
    const read = written(value, piece, unit);
    if (isWrong(read)) return read;
    found.push(`${lead}${read.value}`);
  }
  return { value: found };
}

/** A value as operations read it: millimetres, no blanks. */
function written(value: OperationValue, text: string, unit: LengthUnit): Read<string> {
  const length: Reader = (text) => readLength(text, unit);
  switch (value.is) {
    case "pair":
      return list(text, [length, length]);
    case "vertex":
      return list(
        text,
        [length, length, readNumber].slice(0, text.split(",").length === 3 ? 3 : 2),
      );
    case "triple":
      return list(text, [length, length, length]);
    case "arc":
      return list(text, [length, readAngle]);
    case "length":
      return number(text, length);
    case "number":
      return number(text, readNumber);
    case "wordsOr":
      return value.words.includes(text.toLowerCase())
        ? { value: text.toLowerCase() }
        : number(text, value.length ? length : readNumber);
    case "grid":
      return /^\d+x\d+$/i.test(text)
        ? { value: text.toLowerCase() }
        : { wrong: t("Rows x columns, such as 2x3.") };
    case "shapes":
    case "groups":
      return { value: text.replaceAll(" ", "") };
    default:
      return { value: text };
  }
}

/** Reads one number with its unit, or one without. */
type Reader = (text: string) => Read<number>;

function number(text: string, reader: Reader): Read<string> {
  const read = reader(text);
  return isWrong(read) ? read : { value: num(read.value) };
}

function list(text: string, readers: readonly Reader[]): Read<string> {
  const pieces = text.split(",");
  if (pieces.length !== readers.length)
    return { wrong: t("{0} numbers with commas between.", readers.length) };
  const found: string[] = [];
  for (const [n, piece] of pieces.entries()) {
    const read = number(piece, readers[n] ?? readNumber);
    if (isWrong(read)) return read;
    found.push(read.value);
  }
  return { value: found.join(",") };
}
