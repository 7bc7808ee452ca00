/** Colours of shapes: by group or by direction. */

import type { Shape } from "./geometry/shape";

export const groups = [
  "black",
  "blue",
  "green",
  "cyan",
  "red",
  "magenta",
  "brown",
  "white",
] as const;
export type GroupName = (typeof groups)[number];

export type Hue = "clockwise" | "anticlockwise" | "open" | "crossing" | `group-${GroupName}`;

/** Clockwise red, anticlockwise blue, open green, closed and crossing itself magenta. */
export function hueOf(shape: Shape, groupColours: boolean, crosses: boolean): Hue {
  if (groupColours) return `group-${shape.group as GroupName}`;
  if (!shape.closed) return "open";
  if (crosses) return "crossing";
  return shape.area < 0 ? "clockwise" : "anticlockwise";
}

/** The token that holds a colour. */
export const tokenOf = (hue: Hue): `--${string}` => `--draw-${hue}`;
