/** Places that were kept with the keypad's `#`, as lines of a part file. */

import { locationText } from "../app/units";
import { mm } from "../units/quantity";
import type { AxisUnits, Motion } from "../wire/messages";

/** `J2,3,4`: a jog to the first so many axes. */
export function recorded(axes: number, motion: Motion, units: readonly AxisUnits[]): string {
  const numbers = units.slice(0, axes).map((axis, n) => {
    const text = locationText(motion.at.working[n] ?? mm(0), axis);
    return String(Number(text));
  });
  return [`J${axes}`, ...numbers].join(",");
}
