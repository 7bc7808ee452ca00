/**
 * Lines of one colour as one path, in places of the drawing: made once for a picture and then only
 * stroked, however the window moves.
 */

import Flatbush from "flatbush";
import type { Shape } from "../geometry/shape";
import type { Picture, Stroke } from "../picture";
import { boxInSight } from "../window";
import { type Sheet, traceCross, traceDrawn } from "./pen";

export interface Lines {
  readonly kind: Stroke["kind"];
  readonly token: string;
  readonly dash: boolean;
  readonly path: Path2D;
}

/** Lines that were made for a picture, as long as the picture lives. */
const made = new WeakMap<Picture, Made>();

interface Made {
  readonly all: readonly Lines[];
  readonly index: Flatbush | null;
}

/** Share of the shapes below which only those in sight are stroked. */
const few = 0.3;

/** The lines to be stroked, from the bottom upwards. */
export function linesOf(picture: Picture, { window, size }: Omit<Sheet, "pen">): readonly Lines[] {
  const { strokes } = picture;
  const found = made.get(picture) ?? make(strokes);
  made.set(picture, found);
  if (!found.index) return withPoints(found.all, strokes, window.mmPerPixel);
  const { min, max } = boxInSight(window, size);
  const margin = 8 * window.mmPerPixel;
  const sight = [min.x - margin, min.y - margin, max.x + margin, max.y + margin] as const;
  const seen = found.index.search(...sight);
  const all = seen.length > few * strokes.length;
  const shown = all ? strokes : seen.sort((a, b) => a - b).flatMap((n) => strokes[n] ?? []);
  return withPoints(all ? found.all : batched(shown), shown, window.mmPerPixel);
}

/** An index pays from so many shapes on. */
const worthwhile = 200;

function make(strokes: readonly Stroke[]): Made {
  const all = batched(strokes);
  if (strokes.length < worthwhile) return { all, index: null };
  const index = new Flatbush(strokes.length);
  for (const { shape } of strokes) {
    const { min, max } = shape.box;
    index.add(min.x, min.y, max.x, max.y);
  }
  index.finish();
  return { all, index };
}

/** Segments of one path. A browser that draws with the processor takes more than in proportion for a longer one. */
const together = 200;

function batched(strokes: readonly Stroke[]): Lines[] {
  const found = new Map<string, { all: Lines[]; room: number }>();
  for (const { kind, ink, dash, shape } of strokes) {
    const key = `${kind} ${ink} ${dash}`;
    const lines = found.get(key) ?? { all: [], room: 0 };
    found.set(key, lines);
    if (lines.room <= 0) {
      lines.all.push({ kind, token: ink, dash, path: new Path2D() });
      lines.room = together;
    }
    lines.room -= shape.segments.length;
    const last = lines.all.at(-1);
    if (last) traceDrawn(last.path, shape.segments);
  }
  return [...found.values()].flatMap(({ all }) => all);
}

/** Points are as large at every zoom: rings with a cross. */
function withPoints(
  lines: readonly Lines[],
  strokes: readonly Stroke[],
  mmPerPixel: number,
): readonly Lines[] {
  const points = strokes.filter(({ shape }) => shape.segments.length === 0);
  if (points.length === 0) return lines;
  const found = new Map<string, Lines>();
  for (const { kind, ink, dash, shape } of points) {
    const key = `${kind} ${ink}`;
    const drawn = found.get(key) ?? { kind, token: ink, dash, path: new Path2D() };
    found.set(key, drawn);
    tracePoint(drawn.path, shape, 4 * mmPerPixel);
  }
  return [...lines, ...found.values()];
}

export function tracePoint(path: Path2D, { vertices }: Shape, radius: number): void {
  for (const at of vertices) {
    path.moveTo(at.x + radius, at.y);
    path.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    traceCross(path, at, radius);
  }
}

/** A shape's segments in places of the drawing; a point as a ring with a cross. */
export function traceShape(path: Path2D, shape: Shape, mmPerPixel: number): void {
  if (shape.segments.length > 0) traceDrawn(path, shape.segments);
  else tracePoint(path, shape, 4 * mmPerPixel);
}
