/** The steps by which the arrow keys turn what is being moved. */

const steps = [1, 2, 4, 8, 15, 30, 45, 60, 75, 90] as const;

export const firstStep = 1;

/** From this step on only multiples of it occur. */
const coarse = 15;

export const larger = (step: number): number => steps.find((other) => other > step) ?? 90;
export const smaller = (step: number): number => steps.findLast((other) => other < step) ?? 1;

/** Turned on by a step, counter-clockwise for `way` 1. Counts on beyond a whole turn. */
export function turnedOn(turned: number, step: number, way: 1 | -1): number {
  if (step < coarse) return turned + way * step;
  const whole = way > 0 ? Math.floor(turned / step) : Math.ceil(turned / step);
  return (whole + way) * step;
}

/** 0 … 360 degrees. */
export const wrapped = (turned: number): number => ((turned % 360) + 360) % 360;
