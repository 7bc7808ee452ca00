/** The file of sample answers beside a program: `12:0.25` answers the question of line 12. */

import type { SampleAnswer } from "../wire/messages";

const byLine = /^\s*\d+\s*:/;

/** The text of the file with new answers; lines that answer no line of the program stay as they are. */
export function answersText(
  before: string,
  samples: readonly SampleAnswer[],
  answers: readonly string[],
): string {
  const others = before.split(/\r?\n/).filter((line) => line.trim() !== "" && !byLine.test(line));
  const own = samples.map(({ line }, n) => `${line}:${(answers[n] ?? "").trim()}`);
  return `${[...others, ...own].join("\n")}\n`;
}
