/** The list of variables as lines of OpenSBP, to be changed and added to (UL). */

import type { NamedValue } from "../wire/messages";

/** A number stands for itself; anything else is text. */
const written = (value: string): string =>
  /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(value.trim()) ? value.trim() : `"${value}"`;

export const linesOf = (variables: readonly NamedValue[]): string =>
  variables.map(({ name, value }) => `${name} = ${written(value)}`).join("\n");

const plain = (line: string): string => line.trim();

/** Lines that have to be carried out: those that were not there before. */
export function changedLines(before: string, after: string): string {
  const kept = new Set(before.split("\n").map(plain));
  return after
    .split("\n")
    .map(plain)
    .filter((line) => line !== "" && !kept.has(line))
    .join("\n");
}

/** A line that sets no variable; nothing when every line does. */
export const notAVariable = (text: string): string | undefined =>
  text
    .split("\n")
    .map(plain)
    .find((line) => line !== "" && !/^[&$][^=\s]+\s*:?=/.test(line));
