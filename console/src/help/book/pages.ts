/** The pages of the book, which come with the console and need no network. */

const texts = import.meta.glob<string>(
  ["../../../../docs/book/*.md", "../../../../docs/glossary.md"],
  { query: "?raw", import: "default" },
);

const figures = import.meta.glob<string>("../../../../docs/figures/*.{png,svg}", {
  query: "?url",
  import: "default",
  eager: true,
});

const nameOf = (path: string): string => path.split("/").at(-1)?.replace(/\.md$/, "") ?? "";

/** The address of a figure of the book; nothing where there is none of that name. */
export const figureAddress = (href: string): string | undefined =>
  figures[`../../../../docs/figures/${href.split("/").at(-1)}`];

/** The last chapter: the words of the workshop. */
export const glossary: Chapter = { name: "glossary", title: "Words" };

/** The text of a page. */
export async function pageText(name: string): Promise<string> {
  const read = Object.entries(texts).find(([path]) => nameOf(path) === name)?.[1];
  if (!read) throw new Error(`the book has no page ${name}`);
  return forReaders(await read());
}

/** A page without its part for those who change Kerf. */
export const forReaders = (text: string): string => text.split("\n## Nouns of the code")[0] ?? "";

export interface Chapter {
  readonly name: string;
  readonly title: string;
}

/** The chapters in the order of the summary, and the glossary. */
export const chaptersOf = (summary: string): Chapter[] => [
  ...[...summary.matchAll(/^- \[(.+)\]\((.+)\.md\)$/gm)].map(([, title = "", name = ""]) => ({
    name,
    title,
  })),
  glossary,
];

/** The name of a heading in an address, as the book's own links have it. */
export const anchorOf = (heading: string): string =>
  heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N} _-]/gu, "")
    .trim()
    .replaceAll(" ", "-");

/** A part of the book: the text below a heading. */
export interface Part {
  readonly page: string;
  readonly heading: string;
  readonly text: string;
}

/** A page by its headings. */
export function partsOf(page: string, text: string): Part[] {
  let isCode = false;
  const parts: { heading: string; lines: string[] }[] = [];
  for (const line of text.split("\n")) {
    if (line.startsWith("```")) isCode = !isCode;
    const heading = isCode ? undefined : /^#+ (.+)$/.exec(line)?.[1];
    if (heading !== undefined) parts.push({ heading: heading.replaceAll("`", ""), lines: [] });
    else parts.at(-1)?.lines.push(line);
  }
  return parts.map(({ heading, lines }) => ({ page, heading, text: lines.join("\n") }));
}

/** Every part of the book, read once. */
export const wholeBook = (() => {
  let read: Promise<Part[]> | undefined;
  return (): Promise<Part[]> => {
    const pages = Object.keys(texts)
      .map(nameOf)
      .filter((name) => name !== "SUMMARY");
    read ??= Promise.all(pages.map(async (name) => partsOf(name, await pageText(name)))).then(
      (all) => all.flat(),
    );
    return read;
  };
})();

/** A part that was found, with the words around the first that was looked for. */
export interface Found extends Part {
  readonly around: string;
}

/** Largest number of parts that are shown. */
const mostFound = 20;

/** Parts that hold every word; those whose heading does stand first. */
export function findIn(parts: readonly Part[], wanted: string): Found[] {
  const words = wanted.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const holds = (text: string) => words.filter((word) => text.toLowerCase().includes(word)).length;
  return parts
    .map((part) => ({ part, weight: 10 * holds(part.heading) + holds(part.text) }))
    .filter(({ part }) => holds(`${part.heading} ${part.text}`) === words.length)
    .sort((one, other) => other.weight - one.weight)
    .slice(0, mostFound)
    .map(({ part }) => ({ ...part, around: aroundIn(part.text, words[0] ?? "") }));
}

function aroundIn(text: string, word: string): string {
  const plain = text.replace(/[`*|#]|\]\([^)]*\)|\[/g, "").replace(/\s+/g, " ");
  const at = Math.max(0, plain.toLowerCase().indexOf(word) - 60);
  return `${at > 0 ? "…" : ""}${plain.slice(at, at + 180)}…`;
}
