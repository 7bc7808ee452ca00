/** The values of a chart as they are written. */

import { lengthText } from "../app/units";
import { isMetric, type LengthUnit, mm } from "../units/quantity";
import type { Timing, TimingLine } from "../wire/messages";
import { findingWords } from "../words/findings";
import { t } from "../words/words";
import { nameOf } from "./course";
import { rangeAt } from "./grains";

/** Gives the function that writes values of a line. */
export function readOf({ kind }: Pick<TimingLine, "kind">, unit: LengthUnit) {
  return (value: number): string => {
    if (kind === "axis") return lengthText(mm(value), unit, isMetric(unit) ? 2 : 3);
    if (kind === "value") return String(Math.round(value * 1000) / 1000);
    return value > 0 ? t("on") : t("off");
  };
}

/** Words for a line's value at a moment; for its range, as far as that is known. */
export function valueWords(line: TimingLine, at: number, unit: LengthUnit): string {
  const [low, high] = rangeAt(line, at).map(readOf(line, unit));
  return low === high ? (low ?? "") : `${low} … ${high}`;
}

export const secondsText = (at: number): string => `${at.toFixed(3)} s`;

/** Everything at a moment. */
export const momentWords = (lines: readonly TimingLine[], at: number, unit: LengthUnit): string => {
  const each = lines.map((line) => `${nameOf(line)} ${valueWords(line, at, unit)}`);
  return t("At {0}: {1}", secondsText(at), each.join(", "));
};

const unsaid: Readonly<Record<string, string>> = {
  stopped: t("it was stopped"),
  limit: t("it reached a limit"),
};

/** Tells why a chart does not show all of a run. */
export function endWords(timing: Timing): string | undefined {
  const { whole, full, finding, status } = timing;
  if (whole) return undefined;
  if (full) return t("The chart ends here: the file switches more often than a chart holds.");
  const line = finding && finding.line > 0 ? t(" (line {0})", finding.line) : "";
  const why = finding
    ? `${findingWords(finding).message}${line}`
    : (unsaid[status] ?? t("it failed"));
  return t("It ends at {0}: {1}", secondsText(timing.seconds), why);
}
