/** Values of settings as a person reads them: lengths in inches where those are his unit. */

import { evaluate, resultText } from "../app/expression";
import { type LengthUnit, namedUnit } from "../units/quantity";
import type { SettingEntry } from "../wire/messages";

/** Cutting speeds: told by the minute, while machines' speeds are told by the second. */
const cutting = new Set(["smoothing.cut_speed_mm_s", "plunge.speed_mm_s"]);

/** The unit that is shown for a setting of the configuration, and how many of its own it has. */
export function shownUnit(
  { key, unit }: Pick<SettingEntry, "key" | "unit">,
  page: LengthUnit,
): { unit: string; scale: number } {
  const { name, size } = namedUnit(unit, page);
  return cutting.has(key)
    ? { unit: name.replace("/s", "/min"), scale: size / 60 }
    : { unit: name, scale: size };
}

/** A speed with its unit, as the configuration takes it too. */
const withUnit = /^[\d.]+ ?(mm|m|in)\/(s|min)$/i;

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

export function shownValue(entry: SettingEntry, page: LengthUnit): string {
  const { value, kind } = entry;
  if (kind.is !== "number" && kind.is !== "list") return value;
  const { scale } = shownUnit(entry, page);
  return each(value, (n) => n / scale);
}

/** As it is written in a configuration; nothing when it makes no sense. */
export function writtenValue(
  entry: SettingEntry,
  text: string,
  page: LengthUnit,
): string | undefined {
  const { kind } = entry;
  if (kind.is !== "number" && kind.is !== "list") return text;
  if (entry.unit === "mm/s" && withUnit.test(text.trim())) return text.trim();
  const { scale } = shownUnit(entry, page);
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
