/** Preferences of fill-in sheets in this browser: when they appear, and the last entries. */

import type { CommandEntry } from "../wire/messages";
import type { Entries } from "./sheet";

/** Choice of the commands that bring their sheet as soon as they are typed. */
export type SheetsAppear = "always" | "complex" | "never";

export const sheetsAppear: readonly { readonly value: SheetsAppear; readonly words: string }[] = [
  { value: "always", words: "Always" },
  { value: "complex", words: "Complex" },
  { value: "never", words: "Never" },
];

const appearKey = "kerf.sheets";
const shownKey = (letters: string) => `kerf.sheet.${letters}.shown`;
const lastKey = (letters: string) => `kerf.sheet.${letters}.last`;

/** More parameters than this are hard to type from memory. */
const simple = 6;

export const isComplex = ({ group, parameters }: CommandEntry): boolean =>
  group === "cut" || parameters.length > simple;

export function appear(): SheetsAppear {
  const kept = localStorage.getItem(appearKey);
  return sheetsAppear.find(({ value }) => value === kept)?.value ?? "complex";
}

export const setAppear = (when: SheetsAppear): void => localStorage.setItem(appearKey, when);

/** Tells whether the sheet of this command was not switched off by itself (Alt-D). */
export const isShown = (letters: string): boolean =>
  localStorage.getItem(shownKey(letters)) !== "off";

export const setShown = (letters: string, on: boolean): void =>
  localStorage.setItem(shownKey(letters), on ? "on" : "off");

/** Tells whether typing a command brings its sheet. */
export function bringsSheet(entry: CommandEntry): boolean {
  const when = appear();
  if (when === "never" || entry.parameters.length === 0 || !isShown(entry.letters)) return false;
  return when === "always" || isComplex(entry);
}

export function lastEntries(letters: string): Entries | undefined {
  const kept: unknown = JSON.parse(localStorage.getItem(lastKey(letters)) ?? "null");
  return Array.isArray(kept) ? kept.map(String) : undefined;
}

export const rememberEntries = (letters: string, entries: Entries): void =>
  localStorage.setItem(lastKey(letters), JSON.stringify(entries));
