import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";

const source = join(import.meta.dirname, "..");

/** The files of the console, by their place below the sources. */
const files = readdirSync(source, { recursive: true, encoding: "utf8" });
const sheets = files.filter((name) => name.endsWith(".css"));
const text = (name: string) => readFileSync(join(source, name), "utf8");

it("a rule begins with a class of its own sheet: two sheets with one name would change each other", () => {
  const home = new Map<string, string>();
  const shared: string[] = [];
  for (const sheet of sheets) {
    for (const [, name = ""] of text(sheet).matchAll(/^\.([\w-]+)/gm)) {
      const other = home.get(name) ?? sheet;
      home.set(name, other);
      if (other !== sheet) shared.push(`.${name} in ${other} and ${sheet}`);
    }
  }
  expect(home.size).toBeGreaterThan(100);
  expect(shared).toEqual([]);
});

const tokens = join("theme", "tokens.css");

it("colours are values of the tokens and of nothing else", () => {
  const drawn = files.filter((name) => /\.(css|tsx?)$/.test(name) && !name.endsWith(".test.ts"));
  // Hexadecimal, of a function with numbers, or of a name where a style is given.
  const colour =
    /["'\s(]#(?:[\da-f]{3,4}|[\da-f]{6}|[\da-f]{8})\b|\b(?:rgba?|hsla?|oklch|lab)\(|(?:color|fill|stroke|background|border|Style)[\w-]*\s*[:=]\s*["']?(?:white|black|gray|grey|red|green|blue|yellow|orange)\b/gi;
  const own = drawn
    .filter((name) => name !== tokens && !name.startsWith("wire"))
    .flatMap((name) => (text(name).match(colour) ?? []).map((found) => `${name}: ${found.trim()}`));
  expect(drawn.length).toBeGreaterThan(300);
  expect(own).toEqual([]);
});

it("every name that a style uses has a value: a token, or one that is set in the sources", () => {
  const named = (name: string) =>
    Array.from(text(name).matchAll(/(?:^\s+|")(--[\w-]+)"?:/gm), ([, found]) => found);
  const known = new Set(files.filter((name) => /\.(css|tsx)$/.test(name)).flatMap(named));
  const used = sheets.flatMap((sheet) =>
    Array.from(text(sheet).matchAll(/var\((--[\w-]+)\)/g), ([, name]) => ({ sheet, name })),
  );
  expect(used.length).toBeGreaterThan(500);
  expect(used.filter(({ name }) => !known.has(name))).toEqual([]);
});
