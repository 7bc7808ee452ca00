/** Places and directions in the plane of the drawing, millimetres, x right and y up. */

export interface Place {
  readonly x: number;
  readonly y: number;
}

export const place = (x: number, y: number): Place => ({ x, y });
export const minus = (a: Place, b: Place): Place => ({ x: a.x - b.x, y: a.y - b.y });
export const plus = (a: Place, b: Place): Place => ({ x: a.x + b.x, y: a.y + b.y });
export const times = (a: Place, by: number): Place => ({ x: a.x * by, y: a.y * by });
export const dot = (a: Place, b: Place): number => a.x * b.x + a.y * b.y;
/** Positive when `b` lies to the left of `a`. */
export const cross = (a: Place, b: Place): number => a.x * b.y - a.y * b.x;
export const length = (a: Place): number => Math.hypot(a.x, a.y);
export const distance = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);
/** A quarter turn to the left. */
export const left = (a: Place): Place => ({ x: -a.y, y: a.x });
export const between = (a: Place, b: Place, share: number): Place => ({
  x: a.x + (b.x - a.x) * share,
  y: a.y + (b.y - a.y) * share,
});

/** Turned counter-clockwise about a place, degrees. */
export function turned(a: Place, about: Place, degrees: number): Place {
  const [sin, cos] = sinCos(degrees);
  const { x, y } = minus(a, about);
  return { x: about.x + x * cos - y * sin, y: about.y + x * sin + y * cos };
}

/** Exact at quarter turns. */
function sinCos(degrees: number): [number, number] {
  const whole = ((degrees % 360) + 360) % 360;
  const quarters: Record<number, [number, number]> = {
    0: [0, 1],
    90: [1, 0],
    180: [0, -1],
    270: [-1, 0],
  };
  const radians = (whole * Math.PI) / 180;
  return quarters[whole] ?? [Math.sin(radians), Math.cos(radians)];
}

/** A box; empty when `min` lies behind `max`. */
export interface Box {
  readonly min: Place;
  readonly max: Place;
}

export const noBox: Box = {
  min: place(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY),
  max: place(Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY),
};

export const boxOf = (a: Place, b: Place): Box => ({
  min: place(Math.min(a.x, b.x), Math.min(a.y, b.y)),
  max: place(Math.max(a.x, b.x), Math.max(a.y, b.y)),
});

export const joined = (a: Box, b: Box): Box => ({
  min: place(Math.min(a.min.x, b.min.x), Math.min(a.min.y, b.min.y)),
  max: place(Math.max(a.max.x, b.max.x), Math.max(a.max.y, b.max.y)),
});

export const isEmpty = (box: Box): boolean => box.min.x > box.max.x || box.min.y > box.max.y;
