import { expect, it } from "vitest";
import { german } from "./german/german";
import { textsOfPage } from "./testing";
import { inTable, languageOf } from "./words";

const { spoken, bare } = textsOfPage();

/** Names, signs and keys that are the same in every language. */
const names = ["Kerf", "STOP", "kerf serve", "Alt D", "Alt L", "Alt R", "XY", "VD"];

const hasWords = (text: string): boolean => /\p{L}{2}/u.test(text);

it("every text of the page is put into its language", () => {
  expect([...bare].filter((text) => !names.includes(text)).sort()).toEqual([]);
});

it("every text of the page has German words", () => {
  expect(spoken.size).toBeGreaterThan(1000);
  const missing = [...spoken].filter((text) => hasWords(text) && german[text] === undefined);
  expect(missing.sort()).toEqual([]);
});

it("every German text is one of the page", () => {
  expect(Object.keys(german).filter((text) => !spoken.has(text))).toEqual([]);
});

it("no German text is an English one that has another meaning", () => {
  const twice = Object.values(german).filter((words) => (german[words] ?? words) !== words);
  expect(twice).toEqual([]);
});

const places = (text: string): string[] => (text.match(/\{\d\}/g) ?? []).sort();

it("German texts have the places of the English ones", () => {
  const other = Object.entries(german).filter(([en, de]) => `${places(en)}` !== `${places(de)}`);
  expect(other).toEqual([]);
});

it.each([
  ["{0} of {1}", [1, "a.sbp"], "1 aus a.sbp"],
  ["{0} of {1}", ["{1}", 2], "{1} aus 2"],
  ["not there {0}", ["x"], "not there x"],
  ["{0} and {1}", [1], "1 and {1}"],
])("%s with %j: %s", (text, values, expected) => {
  expect(inTable({ "{0} of {1}": "{0} aus {1}" }, text, values)).toBe(expected);
});

it.each([
  [null, "de-AT", "de"],
  [null, "fr", "en"],
  ["en", "de", "en"],
  ["xx", "de", "en"],
])("chosen %s in a browser of %s: %s", (chosen, browser, language) => {
  expect(languageOf(chosen, browser)).toBe(language);
});
