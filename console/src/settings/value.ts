/** Values of settings as a person reads them: lengths in inches where those are his unit. */

import { evaluate, resultText } from "../app/expression";
import type { SettingEntry } from "../wire/messages";

/** The unit that is shown for one of the configuration, and how many of the latter it has. */
export function shownUnit(unit: string, mm: number): { unit: string; scale: number } {
  const plain = /^mm(\/s[²³]?)?$/.test(unit);
  return plain && mm !== 1 ? { unit: unit.replace("mm", "in"), scale: mm } : { unit, scale: 1 };
}

const isNumber = (text: string): boolean => text.trim() !== "" && Number.isFinite(Number(text));

/** The parts of a value: those of a list, or itself. */
const parts = (text: string): string[] =>
  text
    .replace(/[[\]]/g, "")
    .split(",")
    .map((p) => p.trim());

/** Each number of a value through a function; words stay. */
const each = (text: string, change: (n: number) => number): string =>
  parts(text)
    .map((part) => (isNumber(part) ? resultText(change(Number(part))) : part))
    .join(", ");

export function shownValue({ value, unit, kind }: SettingEntry, mm: number): string {
  if (kind.is !== "number" && kind.is !== "list") return value;
  const { scale } = shownUnit(unit, mm);
  return each(value, (n) => n / scale);
}

/** As it is written in a configuration; nothing when it makes no sense. */
export function writtenValue(entry: SettingEntry, text: string, mm: number): string | undefined {
  const { kind } = entry;
  if (kind.is !== "number" && kind.is !== "list") return text;
  const { scale } = shownUnit(entry.unit, mm);
  const one = (part: string): string | undefined => {
    if (/^[a-z]+$/i.test(part)) return part;
    const value = evaluate(part);
    return value === undefined ? undefined : resultText(value * scale);
  };
  const written = parts(text).map(one);
  if (written.includes(undefined)) return undefined;
  const single = kind.is === "number" || (written.length === 1 && written[0] === "none");
  return single ? written[0] : `[${written.join(", ")}]`;
}
