import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { cards } from "../cards";
import { places } from "../places";
import { anchorOf, chaptersOf, findIn, forReaders, glossary, partsOf } from "./pages";

const folder = join(import.meta.dirname, "../../../../docs/book");
const pages = readdirSync(folder).map((file) => file.replace(/\.md$/, ""));
const words = readFileSync(join(folder, "../glossary.md"), "utf8");
const book = [
  ...pages.flatMap((page) => partsOf(page, readFileSync(join(folder, `${page}.md`), "utf8"))),
  ...partsOf(glossary.name, forReaders(words)),
];

/** Tells whether the book has a page, and a heading there where one is named. */
function exists(place: string): boolean {
  const [page = "", anchor] = place.split("#");
  const there = book.filter((part) => part.page === page);
  return there.length > 0 && (!anchor || there.some(({ heading }) => anchorOf(heading) === anchor));
}

it("every ? and every card leads to a place of the book", () => {
  const all = [...Object.values(places), ...cards.map(({ place }) => place)];
  expect(all.filter((place) => !exists(place))).toEqual([]);
});

it("the summary names pages that exist", () => {
  const summary = readFileSync(join(folder, "SUMMARY.md"), "utf8");
  const chapters = chaptersOf(summary);
  expect(chapters.length).toBeGreaterThan(20);
  expect(chapters.filter(({ name }) => !exists(name))).toEqual([]);
});

it("the glossary ends before the words of the code", () => {
  expect(words.length - forReaders(words).length).toBeGreaterThan(1000);
  expect(forReaders(words)).toContain("| tab |");
});

it("there are twenty cards", () => {
  expect(cards.length).toBeGreaterThanOrEqual(20);
});

it("headings in code are none, and a part with the words in its heading comes first", () => {
  const parts = partsOf("a", "# One\nstop\n```\n# no heading\n```\n## Stop here\ntext\n");
  expect(parts.map(({ heading }) => heading)).toEqual(["One", "Stop here"]);
  expect(findIn(parts, "STOP").map(({ heading }) => heading)).toEqual(["Stop here", "One"]);
  expect(findIn(parts, "stop absent")).toEqual([]);
});
