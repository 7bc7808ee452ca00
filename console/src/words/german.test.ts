import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { german } from "./german";
import { languageOf } from "./words";

const sources = join(import.meta.dirname, "..");

/** Folders whose titles, labels and buttons are in every language. */
const spoken = ["app", "draw", "editor", "help", "keypad", "settings", "ui"];

/** Files whose titles are those of tools, screens and pages. */
const titled = /draw\/tools\/\w+\.ts$|draw\/Toolbox|app\/routes|help\/topics/;

/** Texts of components that are put into the language of the page. */
const patterns = [
  /<(?:Panel|Sheet|Field)\b[^>]*?\b(?:title|label)="([^"]+)"/gs,
  /\bwords: "([^"]+)"/g,
  /<(?:Action)?Button\b(?:[^<>]|=>)*>\s*([^<>{}]+?)\s*<\/(?:Action)?Button>/gs,
];

function textsIn(folder: string): string[] {
  const files = readdirSync(join(sources, folder), { recursive: true, encoding: "utf8" });
  return files
    .filter((file) => /\.tsx?$/.test(file) && !/test/.test(file))
    .flatMap((file) => {
      const source = readFileSync(join(sources, folder, file), "utf8");
      const titles = titled.test(`${folder}/${file}`) ? [/\btitle: "([^"]+)"/g] : [];
      const all = [...patterns, ...titles].flatMap((pattern) => [...source.matchAll(pattern)]);
      return all.map(([, text = ""]) => text.replace(/\s+/g, " "));
    });
}

/** Signs and numbers are the same everywhere. */
const hasWords = (text: string): boolean => /\p{L}{2}/u.test(text);

it("every title, label and button has German words", () => {
  const texts = spoken.flatMap(textsIn);
  expect(texts.length).toBeGreaterThan(100);
  const missing = texts.filter((text) => hasWords(text) && german[text] === undefined);
  expect([...new Set(missing)].sort()).toEqual([]);
});

it.each([
  [null, "de-AT", "de"],
  [null, "fr", "en"],
  ["en", "de", "en"],
  ["xx", "de", "en"],
])("chosen %s in a browser of %s: %s", (chosen, browser, language) => {
  expect(languageOf(chosen, browser)).toBe(language);
});
