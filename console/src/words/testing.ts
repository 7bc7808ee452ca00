/** Texts of the page as they stand in its sources, for tests. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { parseAst } from "vite";

/** A node of the syntax tree: its type, and whatever belongs to it. */
interface Node {
  readonly type: string;
  // biome-ignore lint/suspicious/noExplicitAny: the parts of a node depend on its type
  readonly [part: string]: any;
}

/** Props of components that put them into the language of the page themselves. */
const translated: Readonly<Record<string, readonly string[]>> = {
  Panel: ["title"],
  Sheet: ["title"],
  Field: ["label", "placeholder", "hint"],
  Choice: ["label"],
  Pick: ["label"],
  Button: ["aria-label"],
  ActionButton: ["aria-label"],
};

/** Props that a person reads or hears. */
const read = ["aria-label", "title", "label", "placeholder", "alt", "hint", "empty", "words"];

const hasWords = (text: string): boolean => /\p{L}{2}/u.test(text);

/** A whole sentence, which only a person can be meant to read. */
const isSentence = (text: string): boolean => /^\p{L}[^<>]* [^<>]*[.?!…]$/u.test(text.trim());

/** Text between elements as React shows it. */
const plain = (text: string): string => text.replace(/\s+/g, " ").trim();

const nameOf = (node: Node | undefined): string => node?.name ?? node?.property?.name ?? "";

const stringOf = (node: Node | undefined): string | undefined =>
  node?.type === "Literal" && typeof node.value === "string" ? node.value : undefined;

export interface Texts {
  /** Texts that are put into the language of the page. */
  readonly spoken: Set<string>;
  /** Texts that stay English, whatever is chosen. */
  readonly bare: Set<string>;
}

/** Puts what a node says among the texts; true where nothing below it is looked at. */
type Look = (node: Node, parent: Node | undefined, texts: Texts) => boolean;

const skip: Look = () => true;

const call: Look = ({ callee, arguments: [first] }, _, { spoken }) => {
  const text = stringOf(first);
  if (["t", "phrase"].includes(nameOf(callee)) && text !== undefined) spoken.add(text);
  return false;
};

const between: Look = ({ value }, parent, { spoken, bare }) => {
  const isButton = ["Button", "ActionButton"].includes(nameOf(parent?.openingElement?.name));
  const into = isButton && parent?.children.length === 1 ? spoken : bare;
  if (hasWords(value)) into.add(plain(value));
  return true;
};

const prop: Look = ({ name, value }, parent, { spoken, bare }) => {
  const text = stringOf(value);
  if (text === undefined || !hasWords(text) || !read.includes(nameOf(name))) return false;
  const isSpoken = translated[nameOf(parent?.name)]?.includes(nameOf(name));
  (isSpoken ? spoken : bare).add(text);
  return true;
};

/** A choice has its `words` as they stand in the sources. */
const part: Look = ({ key, value }, _, { spoken }) => {
  const text = nameOf(key) === "words" ? stringOf(value) : undefined;
  if (text !== undefined) spoken.add(text);
  return text !== undefined;
};

const literal: Look = (node, parent, { spoken, bare }) => {
  const text = stringOf(node) ?? "";
  const isSpoken = parent?.type === "CallExpression" && spoken.has(text);
  if (isSentence(text) && !isSpoken) bare.add(text);
  return true;
};

const quasi: Look = ({ value }, _, { bare }) => {
  if (isSentence(value.cooked)) bare.add(value.cooked);
  return true;
};

const looks: Readonly<Record<string, Look>> = {
  ImportDeclaration: skip,
  ThrowStatement: skip,
  CallExpression: call,
  JSXText: between,
  JSXAttribute: prop,
  Property: part,
  Literal: literal,
  TemplateElement: quasi,
};

function walk(node: Node, parent: Node | undefined, texts: Texts): void {
  if (looks[node.type]?.(node, parent, texts)) return;
  for (const below of Object.values(node).flat()) {
    if (below?.type !== undefined) walk(below, node, texts);
  }
}

const sources = join(import.meta.dirname, "..");

/** Folders and files without texts of the page: messages are the server's, the book comes in its own language. */
const others = /^(?:wire|words)\/|test/;

/** The texts of all sources of the page. */
export function textsOfPage(): Texts {
  const texts: Texts = { spoken: new Set(), bare: new Set() };
  const files = readdirSync(sources, { recursive: true, encoding: "utf8" });
  for (const file of files.filter((name) => /\.tsx?$/.test(name) && !others.test(name))) {
    const source = readFileSync(join(sources, file), "utf8");
    const tree = parseAst(source, { lang: file.endsWith("x") ? "tsx" : "ts" });
    walk(tree as unknown as Node, undefined, texts);
  }
  return texts;
}
