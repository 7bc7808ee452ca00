/** Runs as people read them, and parts that were made. */

import { endWord } from "../app/endWords";
import type { RunRecord, ToDo } from "../wire/messages";
import { t } from "../words/words";

/** `finished`, `stopped behind line 12`, `runs`. */
export function endText({ ended, line }: RunRecord): string {
  if (ended === null) return t("runs");
  const word = endWord(ended);
  return ended === "ok" || line === 0 ? word : t("{0} behind line {1}", word, line);
}

export interface Made {
  readonly file: string;
  /** Since midnight. */
  readonly today: number;
  readonly all: number;
}

/** Counts the whole runs of each file, the one that ran last first. */
export function partsMade(runs: readonly RunRecord[], now = new Date()): Made[] {
  const midnight = new Date(now.getFullYear(), now.getMonth(), now.getDate()).getTime() / 1000;
  const made = new Map<string, Made>();
  for (const { file, begun, ended } of runs) {
    if (ended !== "ok") continue;
    const { today, all } = made.get(file) ?? { today: 0, all: 0 };
    made.set(file, { file, today: today + Number(begun >= midnight), all: all + 1 });
  }
  return [...made.values()];
}

/** A file once more on the list: one more is wanted where it stands there. */
export const withOneMore = (list: readonly ToDo[], file: string): ToDo[] =>
  list.some((one) => one.file === file)
    ? wanting(list, file, 1)
    : [...list, { file, wanted: 1, made: 0 }];

/** So many more of a file are wanted, one at least. */
export const wanting = (list: readonly ToDo[], file: string, more: number): ToDo[] =>
  list.map((one) => (one.file === file ? { ...one, wanted: Math.max(1, one.wanted + more) } : one));

/** The list with a file one place higher. */
export function earlier(list: readonly ToDo[], file: string): ToDo[] {
  const at = list.findIndex((one) => one.file === file);
  const [before, one] = [list[at - 1], list[at]];
  return before && one ? [...list.slice(0, at - 1), one, before, ...list.slice(at + 1)] : [...list];
}
