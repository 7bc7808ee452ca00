/** Arithmetic on measured lengths: the steps of an axis, and how far a machine is out of square. */

import type { Mm } from "../units/quantity";

/** Steps of a unit that make the way that was measured the way that was asked for. */
export const truerSteps = (steps: number, asked: Mm, measured: Mm): number =>
  (steps * asked) / measured;

export interface Squareness {
  /** The angle between X and Y is so much less than a right one, degrees. */
  readonly degrees: number;
  /** The right motor has to come to the front by so much, mm; to the back where it is negative. */
  readonly front: number;
}

/**
 * The squareness of a rectangle that was made `x` by `y` large, from its diagonals: `d1` from the front left corner, `d2`
 * from the front right one. Y leans by the angle a towards +X: d1² - d2² = 4 x y sin a, and a gantry whose motors are
 * `apart` is off by `apart` tan a. Nothing where no rectangle has such diagonals.
 */
export function squareness(x: Mm, y: Mm, d1: Mm, d2: Mm, apart: Mm): Squareness | undefined {
  const sine = (d1 * d1 - d2 * d2) / (4 * x * y);
  if (!(Math.abs(sine) < 1)) return undefined;
  const angle = Math.asin(sine);
  return { degrees: (angle * 180) / Math.PI, front: apart * Math.tan(angle) };
}

/** The numbers of a list setting, as `[80, 80, 400]`. */
export const numbersOf = (value: string): number[] =>
  value.replace(/[[\]]/g, "").split(",").map(Number);

/** A list setting with another number at a place. */
export const withNumber = (value: string, at: number, number: number): string =>
  `[${numbersOf(value)
    .map((old, n) => (n === at ? Number(number.toPrecision(9)) : old))
    .join(", ")}]`;
