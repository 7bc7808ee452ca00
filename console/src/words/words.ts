/** The language of the page: English as it is written in the sources, or another by its table. */

import { german } from "./german";

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

/** A text in the language of the page; one that has no other stays English. */
export const t = (text: string): string => tables[language][text] ?? text;

/** Chooses another language: the page is loaded again in it. */
export function speak(next: Language): void {
  localStorage.setItem(key, next);
  location.reload();
}
