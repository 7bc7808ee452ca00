/**
 * Shapes in space: a flat one once for each pass, at the height at which it is cut; one that is cut by
 * its own heights as it is, counted from the surface of the material.
 */

import type { Vec3 } from "../../view/camera";
import type { GroupState, Motion, ZHeights } from "../../wire/messages";
import { arcOf, isLine, placeAt, type Segment } from "../geometry/segment";
import type { Shape } from "../geometry/shape";

/** Arcs are drawn by chords of this angle, radians. */
const chord = Math.PI / 36;

type Depths = Pick<GroupState, "levels">;

/** The lines of a shape, one for each pass. */
export function lifted(shape: Shape, { levels }: Depths, { surface }: ZHeights): Vec3[][] {
  const flat = outline(shape);
  if (levels.length === 0) return [flat.map(([x, y, z]) => [x, y, surface + z])];
  return levels.map((level) => flat.map(([x, y]) => [x, y, level]));
}

/** The places along a shape, with its own heights; 0 for those of a flat one. */
function outline({ vertices, segments, z }: Shape): Vec3[] {
  const height = (n: number): number => z?.[n % vertices.length] ?? 0;
  const first = vertices[0];
  if (!first) return [];
  const rest = segments.flatMap((segment, n) => along(segment, height(n), height(n + 1)));
  return [[first.x, first.y, height(0)], ...rest];
}

/** Places behind the start of a segment, up to its end. */
function along(segment: Segment, from: number, to: number): Vec3[] {
  const count = isLine(segment) ? 1 : Math.ceil(Math.abs(arcOf(segment).sweep) / chord);
  return Array.from({ length: count }, (_, n) => {
    const share = (n + 1) / count;
    const { x, y } = share === 1 ? segment.to : placeAt(segment, share);
    return [x, y, from + (to - from) * share];
  });
}

/** The tool in the drawing: zero of its Z is the surface of the material. */
export function toolIn({ at: { working } }: Motion, { surface }: ZHeights): Vec3 {
  const [x, y, z] = working;
  return [x, y, surface + z];
}
