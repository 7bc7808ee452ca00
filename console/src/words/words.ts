/** The language of the page: English as it is written in the sources, or another by its table. */

import { createElement, Fragment, type ReactNode } from "react";
import { german } from "./german/german";

export const languages = [
  { value: "en", words: "English" },
  { value: "de", words: "Deutsch" },
] as const;

export type Language = (typeof languages)[number]["value"];

/** A text for each English one. */
export type Table = Readonly<Record<string, string>>;

const tables: Record<Language, Table> = { en: {}, de: german };

const key = "kerf.language";

/** The language that was chosen, else the browser's where there is a table of it. */
export function languageOf(chosen: string | null, browser: string): Language {
  const wanted = chosen ?? browser.slice(0, 2).toLowerCase();
  return languages.find(({ value }) => value === wanted)?.value ?? "en";
}

const here = (): Language =>
  typeof localStorage === "undefined"
    ? "en"
    : languageOf(localStorage.getItem(key), navigator.language);

/** The language of this page, for as long as it is open. */
export const language: Language = here();

const place = /\{(\d)\}/;

/** A text in a language, with values in its places `{0}`, `{1}`; one that the table does not have stays English. */
export const inTable = (table: Table, text: string, values: readonly (string | number)[]): string =>
  (table[text] ?? text).replace(new RegExp(place, "g"), (kept, at) => String(values[at] ?? kept));

/** A text in the language of the page. */
export const t = (text: string, ...values: (string | number)[]): string =>
  inTable(tables[language], text, values);

/** A text in the language of the page with parts of the page in its places. */
export const phrase = (text: string, ...parts: ReactNode[]): ReactNode => {
  const pieces = t(text).split(place);
  const shown = pieces.map((piece, n) => (n % 2 === 0 ? piece : parts[Number(piece)]));
  return createElement(Fragment, null, ...shown);
};

/** Chooses another language: the page is loaded again in it. */
export function speak(next: Language): void {
  localStorage.setItem(key, next);
  location.reload();
}
