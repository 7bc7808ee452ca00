import type { AxisUnits, Zero } from "../wire/messages";

/** The shift of all zero points, which is a way and no place. */
export const shift = "G92";

/**
 * The command by which a zero point becomes zero X, Y and Z: the places that the axes then read, where the machine
 * stands.
 */
export function takes(zero: Zero, machine: readonly number[], axes: readonly AxisUnits[]): string {
  const reads = axes.slice(0, 3).map(({ scale }, axis) => {
    const way = ((machine[axis] ?? 0) - (zero.at[axis] ?? 0)) / scale;
    return String(Number(way.toFixed(6)));
  });
  return `VA,${reads.join(",")}`;
}
