/** Changes of place as canvases take them. */

import type { Place } from "../geometry/vec";
import type { Matrix } from "./tool";

export const shifted = (from: Place, to: Place): Matrix => [
  1,
  0,
  0,
  1,
  to.x - from.x,
  to.y - from.y,
];

/** Counter-clockwise about a place, degrees. */
export function spun(about: Place, degrees: number): Matrix {
  const radians = (degrees * Math.PI) / 180;
  const [c, s] = [Math.cos(radians), Math.sin(radians)];
  return [c, s, -s, c, about.x - c * about.x + s * about.y, about.y - s * about.x - c * about.y];
}

export const grown = (about: Place, factor: number): Matrix => [
  factor,
  0,
  0,
  factor,
  about.x * (1 - factor),
  about.y * (1 - factor),
];

/** Mirrored at the line through two places. */
export function mirrored(a: Place, b: Place): Matrix {
  const twice = 2 * Math.atan2(b.y - a.y, b.x - a.x);
  const [c, s] = [Math.cos(twice), Math.sin(twice)];
  return [c, s, s, -c, a.x - c * a.x - s * a.y, a.y - s * a.x + c * a.y];
}

/** First `inner`, then `outer`. */
export const after = (outer: Matrix, inner: Matrix): Matrix => {
  const [a, b, c, d, e, f] = outer;
  const [p, q, r, s, t, u] = inner;
  return [
    a * p + c * q,
    b * p + d * q,
    a * r + c * s,
    b * r + d * s,
    a * t + c * u + e,
    b * t + d * u + f,
  ];
};
