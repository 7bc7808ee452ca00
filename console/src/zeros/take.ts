import { type AxisValue, difference, inAxisUnit, mm } from "../units/quantity";
import type { AxisUnits, Zero } from "../wire/messages";

/** The shift of all zero points, which is a way and no place. */
export const shift = "G92";

/**
 * The command by which a zero point becomes zero X, Y and Z: the places that the axes then read, where the machine
 * stands.
 */
export function takes(
  zero: Zero,
  machine: readonly AxisValue[],
  axes: readonly AxisUnits[],
): string {
  const reads = axes.slice(0, 3).map((axis, n) => {
    const way = inAxisUnit(difference(machine[n] ?? mm(0), zero.at[n] ?? mm(0)), axis);
    return String(Number(way.toFixed(6)));
  });
  return `VA,${reads.join(",")}`;
}
