/** Lines between Kerf and the controller: those that are kept on the page, and those of them that are shown. */

import type { ControllerLine } from "../wire/messages";

/** Lines that the page keeps at most: the server and the saved file have more. */
export const mostKept = 5000;

/** Lines that are drawn at most. */
export const mostShown = 500;

/** Choice of the lines that are shown: all, one way, or errors. */
export type Way = "all" | "sent" | "came" | "errors";

/** Lines with further ones behind them, the oldest left out. */
export const kept = (
  before: readonly ControllerLine[],
  further: readonly ControllerLine[],
): readonly ControllerLine[] =>
  further.length === 0 ? before : [...before, ...further].slice(-mostKept);

/** Kinds of lines that tell of an error; those of the connection tell why. */
const wrong = new Set<ControllerLine["kind"]>(["error", "alarm", "link"]);

/** The lines that are shown, the last ones of those that are of the way and hold the text. */
export function shownOf(
  lines: readonly ControllerLine[],
  way: Way,
  search: string,
  words: (line: ControllerLine) => string,
): readonly ControllerLine[] {
  const wanted = search.trim().toLowerCase();
  const goes = (line: ControllerLine) => {
    if (way === "errors") return wrong.has(line.kind);
    return way === "all" || line.kind === "link" || line.sent === (way === "sent");
  };
  const holds = (line: ControllerLine) =>
    wanted === "" || `${line.text} ${words(line)}`.toLowerCase().includes(wanted);
  return lines.filter((line) => goes(line) && holds(line)).slice(-mostShown);
}

/** The time of day of a line, with its thousandths: `14:03:07.120`. */
export function timeOf({ at }: ControllerLine): string {
  const date = new Date(at * 1000);
  const two = (number: number) => String(number).padStart(2, "0");
  const ms = String(date.getMilliseconds()).padStart(3, "0");
  return `${two(date.getHours())}:${two(date.getMinutes())}:${two(date.getSeconds())}.${ms}`;
}
