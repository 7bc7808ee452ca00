import { placeOf } from "../tools/moveTo";
import type { AxisValue } from "../units/quantity";
import type { AxisUnits, ZeroChange } from "../wire/messages";
import { t } from "../words/words";

/** Meaning of the numbers of axes: their reading where the tool is, or the place of the zero point. */
export type Meaning = "reads" | "lies";

/** A change of a zero point by the numbers that were entered for axes, or the reason why there is none. */
export function changeOf(
  axes: readonly { readonly axis: AxisUnits; readonly at: number }[],
  entries: Readonly<Record<string, string>>,
  read: (text: string, axis: AxisUnits) => AxisValue | undefined,
  meaning: Meaning,
): ZeroChange | string {
  const numbers = placeOf(axes, entries, read);
  if (typeof numbers === "string") return numbers;
  if (numbers.every((value) => value === null)) return t("Give a number for one axis at least.");
  return meaning === "reads" ? { to: "reads", values: numbers } : { to: "lies", at: numbers };
}
