/** The values of a chart as they are written. */

import type { Timing, TimingLine } from "../wire/messages";
import { nameOf } from "./course";
import { rangeAt } from "./grains";

/** What lengths are shown in. */
export interface Units {
  readonly mm: number;
  readonly linear: string;
}

/** How values of a line are written. */
export function readOf({ kind }: Pick<TimingLine, "kind">, { mm, linear }: Units) {
  return (value: number): string => {
    if (kind === "axis") return `${(value / mm).toFixed(mm === 1 ? 2 : 3)} ${linear}`;
    if (kind === "value") return String(Math.round(value * 1000) / 1000);
    return value > 0 ? "on" : "off";
  };
}

/** What a line is at a moment; from where to where, as far as that is known. */
export function valueWords(line: TimingLine, at: number, units: Units): string {
  const [low, high] = rangeAt(line, at).map(readOf(line, units));
  return low === high ? (low ?? "") : `${low} … ${high}`;
}

export const seconds = (at: number): string => `${at.toFixed(3)} s`;

/** Everything at a moment. */
export const momentWords = (lines: readonly TimingLine[], at: number, units: Units): string => {
  const each = lines.map((line) => `${nameOf(line)} ${valueWords(line, at, units)}`);
  return `At ${seconds(at)}: ${each.join(", ")}`;
};

const unsaid: Readonly<Record<string, string>> = {
  stopped: "it was stopped",
  limit: "it reached a limit",
};

/** Why a chart does not show all of a run. */
export function endWords(timing: Timing): string | undefined {
  const { whole, full, finding, status } = timing;
  if (whole) return undefined;
  if (full) return "The chart ends here: the file switches more often than a chart holds.";
  const line = finding && finding.line > 0 ? ` (line ${finding.line})` : "";
  const why = finding ? `${finding.message}${line}` : (unsaid[status] ?? "it failed");
  return `It ends at ${seconds(timing.seconds)}: ${why}`;
}
