/** Finds the shapes under the pointer: an index of all segments of a drawing. */

import Flatbush from "flatbush";
import { distanceTo, type Segment, segmentBox } from "./geometry/segment";
import type { Shape } from "./geometry/shape";
import { distance, type Place } from "./geometry/vec";

/** A segment, or a vertex of a shape that has none. */
export interface Piece {
  readonly shape: Shape;
  /** Nothing for a point. */
  readonly segment: Segment | null;
}

export interface Picking {
  readonly shapes: readonly Shape[];
  /** The pieces within a distance of a place. */
  near(at: Place, radius: number): Piece[];
}

/** Makes the index. Shapes that cannot be picked, those of groups that are hidden, are left out. */
export function pickingOf(shapes: readonly Shape[]): Picking {
  const pieces = shapes.flatMap(piecesOf);
  if (pieces.length === 0) return { shapes, near: () => [] };
  const index = new Flatbush(pieces.length);
  for (const { shape, segment } of pieces) {
    const { min, max } = segment ? segmentBox(segment) : shape.box;
    index.add(min.x, min.y, max.x, max.y);
  }
  index.finish();
  return {
    shapes,
    near: (at, radius) =>
      index
        .search(at.x - radius, at.y - radius, at.x + radius, at.y + radius)
        .flatMap((n) => pieces[n] ?? [])
        .filter((piece) => pieceDistance(piece, at) <= radius),
  };
}

const piecesOf = (shape: Shape): Piece[] =>
  shape.segments.length === 0
    ? [{ shape, segment: null }]
    : shape.segments.map((segment) => ({ shape, segment }));

export const pieceDistance = ({ shape, segment }: Piece, at: Place): number =>
  segment
    ? distanceTo(segment, at)
    : Math.min(...shape.vertices.map((vertex) => distance(vertex, at)));

/** The shapes within a distance, each once, in cutting order. */
export function shapesNear(picking: Picking, at: Place, radius: number): Shape[] {
  const found = new Map(picking.near(at, radius).map(({ shape }) => [shape.number, shape]));
  return [...found.values()].sort((a, b) => a.number - b.number);
}
