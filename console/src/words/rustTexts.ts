/** Sentences in the sources of the server, for tests that hold the German ones to them. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const crates = join(import.meta.dirname, "../../../crates");

/** Matches the next part of a Rust source: a comment, a text, a character, or any other sign. */
const piece =
  /\/\/[^\n]*|r(#*)"([\s\S]*?)"\1|"((?:\\[\s\S]|[^"\\])*)"|'(?:\\[^']+|[^'\\])'|[\s\S]/g;

/** Returns a text as it is said, with `{}` for each value that a format puts in. */
const plain = (text: string): string =>
  text
    .replace(/\\\n\s*/g, "")
    .replace(/\\n/g, "\n")
    .replace(/\\(["\\'])/g, "$1")
    .replace(/\{\{|\}\}/g, (brace) => brace.charAt(0))
    .replace(/\{[\w.:?<>]*\}/g, "{}");

/** Begins of code whose texts only programmers read. */
const forProgrammers =
  /(?:expect|expect_err|assert|assert_eq|debug_assert|panic|unreachable|include_str|concat|env|reason\s*=)!?\s*\(?\s*$/;

/** The texts of a source, without tests and attributes. */
export function textsOfSource(source: string): string[] {
  const spoken = source.split(/#\[cfg\(test\)\]\n(?:#\[[^\n]*\n)*mod \w+ \{/)[0] ?? "";
  const code = spoken.replace(/^\s*#!?\[(?!error)[^\n]*\]$/gm, "");
  const texts: string[] = [];
  let before = "";
  for (const [whole, , raw, text] of code.matchAll(piece)) {
    const said = raw ?? (text === undefined ? undefined : plain(text));
    if (said !== undefined && !forProgrammers.test(before)) texts.push(said);
    before = said === undefined ? (before + whole).slice(-20) : "";
  }
  return texts;
}

/** The texts of a crate's sources, with their files. */
export function textsOfCrate(crate: string): Map<string, string> {
  const folder = join(crates, crate, "src");
  const names = readdirSync(folder, { recursive: true, encoding: "utf8" }).sort();
  const files = names.filter((name) => name.endsWith(".rs") && !/(?:^|\/)tests?[./]/.test(name));
  const texts = files.flatMap((name) =>
    textsOfSource(readFileSync(join(folder, name), "utf8")).map((text) => [text, name] as const),
  );
  return new Map(texts);
}
