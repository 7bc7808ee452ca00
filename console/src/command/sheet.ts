/** A fill-in sheet as values: what is entered, what is wrong with it, the line it makes. */

import { evaluate } from "../app/expression";
import { type LengthUnit, ofUnit, shown } from "../units/quantity";
import type { CommandEntry, FileParameters, Parameter } from "../wire/messages";
import { t } from "../words/words";

/** Entry for each parameter, in the order of the part file; blank is not given. */
export type Entries = readonly string[];

/** Entries of a new sheet: those typed so far, else present settings, else defaults. */
export function firstEntries(entry: CommandEntry, given: readonly string[]): Entries {
  return entry.parameters.map((parameter, n) => given[n] || startOf(parameter));
}

const startOf = ({ default: usual, present }: Parameter): string => present ?? usual ?? "";

/** Everything as it is when nothing is said. */
export const resetEntries = (entry: CommandEntry): Entries => firstEntries(entry, []);

export const withEntry = (entries: Entries, n: number, text: string): Entries =>
  entries.map((old, k) => (k === n ? text : old));

/** Parameters that are seldom given stand last on a sheet, wherever they stand in the line. */
const seldom = /^Feature$/;

/** The order in which a sheet shows its parameters, by their places in the line. */
export function sheetOrder({ parameters }: CommandEntry): number[] {
  const places = parameters.map((_, n) => n);
  const last = (n: number) => seldom.test(parameters[n]?.name ?? "");
  return [...places.filter((n) => !last(n)), ...places.filter(last)];
}

/** Finds the mistake in an entry; nothing when it may be sent. */
export function mistakeIn(parameter: Parameter, text: string): string | undefined {
  const written = text.trim();
  if (written === "") return parameter.required ? t("This has to be given.") : undefined;
  const { kind } = parameter;
  const plain = kind.is === "number" || kind.is === "whole" || kind.is === "numberOrOff";
  if (!plain) return undefined;
  if (kind.is === "numberOrOff" && written.toUpperCase() === "OFF") return undefined;
  // Variables are known to the server only.
  if (/[&%]/.test(written)) return undefined;
  const value = evaluate(written);
  if (value === undefined) return t("This is not a number.");
  return outside(parameter, value);
}

function outside({ least, most, bound }: Parameter, value: number): string | undefined {
  const low = least !== null && value < least;
  const high = most !== null && value > most;
  return low || high ? t("Allowed: {0}.", bound || rangeText(least, most)) : undefined;
}

/** `0 to 99`, `at least 0`, `at most 99`. */
export function rangeText(least: number | null, most: number | null): string {
  if (least !== null && most !== null) return t("{0} to {1}", least, most);
  if (least !== null) return t("at least {0}", least);
  return most !== null ? t("at most {0}", most) : "";
}

/** Mistakes by the place of their parameter. */
export function mistakesIn(entry: CommandEntry, entries: Entries): ReadonlyMap<number, string> {
  const found = entry.parameters.map((p, n) => [n, mistakeIn(p, entries[n] ?? "")] as const);
  return new Map(found.filter((one): one is [number, string] => one[1] !== undefined));
}

/** The line as it would stand in a part file. What says only what is usual is left out at the end. */
export function lineOf(entry: CommandEntry, entries: Entries): string {
  const written = entries.map((text) => text.trim());
  const usual = (n: number) => {
    const parameter = entry.parameters[n];
    if (written[n] === "") return true;
    // What has to be given is written, even where it is what holds already.
    return parameter !== undefined && !parameter.required && written[n] === startOf(parameter);
  };
  let length = written.length;
  while (length > 0 && usual(length - 1)) length -= 1;
  return [entry.letters, ...written.slice(0, length).map(asWritten)].join(",");
}

/** Text with a comma in it stands in quotes. */
const asWritten = (text: string): string =>
  text.includes(",") && !text.startsWith('"') ? `"${text}"` : text;

/**
 * Parts a text that is typed into a field at a comma: the text that stays, and true if the next field is
 * meant. A comma in quotes parts nothing. A comma right behind the letters of the command is dropped: the
 * sheet came while `FP,part.sbp` was being typed.
 */
export function parted(text: string, first: boolean): { kept: string; goesOn: boolean } {
  const written = first ? text.replace(/^[\s,]+/, "") : text;
  const quotes = written.split('"').length - 1;
  const goesOn = written.endsWith(",") && quotes % 2 === 0;
  return { kept: goesOn ? written.slice(0, -1) : written, goesOn };
}

/** Choices of the FP sheet for running a file; lengths are in the unit of the page. */
export function fileParameters(entries: Entries, unit: LengthUnit): FileParameters {
  const number = (n: number, usual: number) => evaluate(entries[n]?.trim() ?? "") ?? usual;
  return {
    proportion: [number(1, 1), number(2, 1), number(3, 1)],
    repetitions: number(4, 1),
    offset: number(5, 0),
    plunge: ofUnit(shown(number(6, 0)), unit),
    tabs: number(7, 0) !== 0,
    plungeFromZero: number(8, 0) !== 0,
  };
}
