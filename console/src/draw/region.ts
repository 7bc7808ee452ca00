/** Finds the shapes of a region: those wholly inside, or also those it touches. */

import { meetings } from "./geometry/segment";
import type { Shape } from "./geometry/shape";
import { type Box, boxOf, type Place } from "./geometry/vec";
import { frame } from "./tools/insert";

/** A region begun at its left takes what is wholly inside, one begun at its right what it touches. */
export const isCrossing = (from: Place, to: Place): boolean => to.x < from.x;

export function shapesIn(shapes: readonly Shape[], from: Place, to: Place): Shape[] {
  const box = boxOf(from, to);
  const inside = (shape: Shape) => contains(box, shape.box);
  if (!isCrossing(from, to)) return shapes.filter(inside);
  const sides = frame(from, to);
  const touches = (shape: Shape) =>
    shape.vertices.some((vertex) => contains(box, boxOf(vertex, vertex))) ||
    shape.segments.some((segment) => sides.some((side) => meetings(segment, side).length > 0));
  return shapes.filter((shape) => inside(shape) || touches(shape));
}

/** True for a place inside a region. */
export const isWithin = (at: Place, from: Place, to: Place): boolean =>
  contains(boxOf(from, to), boxOf(at, at));

const contains = (outer: Box, inner: Box): boolean =>
  inner.min.x >= outer.min.x &&
  inner.max.x <= outer.max.x &&
  inner.min.y >= outer.min.y &&
  inner.max.y <= outer.max.y;
