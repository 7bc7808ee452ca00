import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { textsOfPage } from "../words/testing";
import { anchorOf } from "./book/pages";
import { places } from "./places";

const sources = join(import.meta.dirname, "..");
const book = join(import.meta.dirname, "../../../docs/book");

/** Panels and sheets beside which nothing is left to say. */
const plain = [
  "Calculator",
  "Every action",
  "Load settings?",
  "Empty the bin?",
  "Pair this device",
];

it("every place is a page of the book and a heading on it", () => {
  const wrong = Object.values(places).filter((place) => {
    const [page = "", anchor] = place.split("#");
    const text = readFileSync(join(book, `${page}.md`), "utf8");
    const headings = [...text.matchAll(/^#+ (.+)$/gm)].map(([, heading = ""]) => anchorOf(heading));
    return anchor !== undefined && !headings.includes(anchor);
  });
  expect(wrong).toEqual([]);
});

it("every panel and every sheet has its place in the book", () => {
  const files = readdirSync(sources, { recursive: true, encoding: "utf8" });
  const titles = files
    .filter((name) => name.endsWith(".tsx"))
    .flatMap((name) => [
      ...readFileSync(join(sources, name), "utf8").matchAll(
        /<(?:Panel|Sheet)\s+(?:about="([^"]+)"\s+)?title=(?:\{t\()?"([^"{]+)"/g,
      ),
    ])
    .map(([, about, title = ""]) => about ?? title);
  expect(titles.length).toBeGreaterThan(30);
  const without = titles.filter((title) => places[title] === undefined && !plain.includes(title));
  expect([...new Set(without)]).toEqual([]);
});

it("every place is that of a title of the page", () => {
  const { spoken } = textsOfPage();
  expect(Object.keys(places).filter((title) => !spoken.has(title))).toEqual([]);
});
