/** Moves to places that are given in numbers, as the machine is asked for them. */

import { type AxisGoal, type AxisValue, goal } from "../units/quantity";
import type { AxisUnits, ByHand } from "../wire/messages";
import { t } from "../words/words";

type Axes = readonly { readonly axis: AxisUnits; readonly at: number }[];
type Entries = Readonly<Record<string, string>>;
/** Reads a number of an axis. */
type Reader = (text: string, axis: AxisUnits) => AxisValue | undefined;

/** A move, or what is wrong with what was entered. */
export type Made = ByHand | { readonly wrong: string };

export const isWrong = (made: Made): made is { readonly wrong: string } => "wrong" in made;

/** The number entered for each axis; nothing of those that stay. */
export function placeOf(axes: Axes, entries: Entries, read: Reader): AxisGoal | string {
  const place: (AxisValue | null)[] = [null, null, null, null, null, null];
  for (const { axis, at } of axes) {
    const text = (entries[axis.letter] ?? "").trim();
    if (text === "") continue;
    const value = read(text, axis);
    if (value === undefined) return t("{0}: {1} is no number.", axis.letter, text);
    place[at] = value;
  }
  return goal(place);
}

export function moveTo(
  axes: Axes,
  entries: Entries,
  read: Reader,
  how: { readonly relative: boolean; readonly flat: boolean },
): Made {
  const place = placeOf(axes, entries, read);
  if (typeof place === "string") return { wrong: place };
  if (place.every((value) => value === null))
    return { wrong: t("Give a place for one axis at least.") };
  return { to: "place", place, ...how };
}

export function cutMove(axes: Axes, entries: Entries, read: Reader, cut: boolean): Made {
  const place = placeOf(axes, entries, read);
  if (typeof place === "string") return { wrong: place };
  const [x, y] = place;
  if (x == null || y == null) return { wrong: t("Give X and Y.") };
  return { to: "cutMove", at: [x, y], cut };
}
