import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";

const source = join(import.meta.dirname, "..");

/** The style sheets of the console, by their place below the sources. */
const sheets = readdirSync(source, { recursive: true, encoding: "utf8" }).filter((name) =>
  name.endsWith(".css"),
);

it("a rule begins with a class of its own sheet: two sheets with one name would change each other", () => {
  const home = new Map<string, string>();
  const shared: string[] = [];
  for (const sheet of sheets) {
    const text = readFileSync(join(source, sheet), "utf8");
    for (const [, name = ""] of text.matchAll(/^\.([\w-]+)/gm)) {
      const other = home.get(name) ?? sheet;
      home.set(name, other);
      if (other !== sheet) shared.push(`.${name} in ${other} and ${sheet}`);
    }
  }
  expect(home.size).toBeGreaterThan(100);
  expect(shared).toEqual([]);
});
