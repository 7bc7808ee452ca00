/** A shape of the drawing as the page draws, picks and snaps to it. */

import type { ShapePath } from "../../wire/messages";
import { arcOf, isLine, type Segment, segmentBox } from "./segment";
import { type Box, boxOf, cross, joined, noBox, type Place, place } from "./vec";

export interface Shape {
  /** From 1, in the order in which shapes are cut. */
  readonly number: number;
  readonly group: string;
  readonly closed: boolean;
  readonly pause: boolean;
  readonly vertices: readonly Place[];
  /** Heights of the vertices of a 3D shape. */
  readonly z: readonly number[] | null;
  /** None for a point. */
  readonly segments: readonly Segment[];
  readonly box: Box;
  /** Square millimetres, positive for a counter-clockwise closed shape; 0 for an open one. */
  readonly area: number;
}

/** Three numbers a vertex: x, y, bulge of the segment behind it. */
export function shapeOf(path: ShapePath): Shape {
  const count = Math.floor(path.points.length / 3);
  const at = (n: number) => place(path.points[3 * n] ?? 0, path.points[3 * n + 1] ?? 0);
  const vertices = Array.from({ length: count }, (_, n) => at(n));
  const last = path.closed ? count : count - 1;
  const segments = Array.from({ length: Math.max(last, 0) }, (_, n) => ({
    from: at(n),
    to: at((n + 1) % count),
    bulge: path.points[3 * n + 2] ?? 0,
  }));
  const { number, group, closed, pause, z } = path;
  const box = segments.map(segmentBox).reduce(joined, boxOfPlaces(vertices));
  return {
    number,
    group,
    closed,
    pause,
    z,
    vertices,
    segments,
    box,
    area: closed ? areaOf(segments) : 0,
  };
}

const boxOfPlaces = (places: readonly Place[]): Box =>
  places.map((at) => boxOf(at, at)).reduce(joined, noBox);

/** Area by the shoelace formula, and the segments of the circles beside the chords. */
function areaOf(segments: readonly Segment[]): number {
  return segments.reduce((sum, segment) => {
    const flat = cross(segment.from, segment.to) / 2;
    if (isLine(segment)) return sum + flat;
    const { radius, sweep } = arcOf(segment);
    return sum + flat + (radius * radius * (sweep - Math.sin(sweep))) / 2;
  }, 0);
}

/** The box of all of them. */
export const boxOfShapes = (shapes: readonly Shape[]): Box =>
  shapes.reduce((box, shape) => joined(box, shape.box), noBox);
