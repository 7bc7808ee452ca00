/** Lines and arcs on a canvas, from places of the drawing. */

import { arcOf, isLine, type Segment } from "../geometry/segment";
import type { Place } from "../geometry/vec";
import { type Size, toPixels, type Window } from "../window";

export interface Sheet {
  readonly pen: CanvasRenderingContext2D;
  readonly window: Window;
  readonly size: Size;
}

/** Prepares a canvas for a picture of that size, sharp on screens with small pixels. */
export function sheetOn(canvas: HTMLCanvasElement, window: Window, size: Size): Sheet | null {
  const pen = canvas.getContext("2d");
  if (!pen) return null;
  const ratio = Math.min(devicePixelRatio, 2);
  canvas.width = size.width * ratio;
  canvas.height = size.height * ratio;
  pen.scale(ratio, ratio);
  return { pen, window, size };
}

export const pixel = ({ window, size }: Sheet, at: Place): Place => toPixels(window, size, at);

/** Shapes smaller than this are drawn as one dot, pixels. */
const dot = 0.6;

/** Adds segments that follow each other to a path. */
export function trace(sheet: Sheet, path: Path2D, segments: readonly Segment[]): void {
  const first = segments[0];
  if (!first) return;
  const start = pixel(sheet, first.from);
  path.moveTo(start.x, start.y);
  for (const segment of segments) traceOne(sheet, path, segment);
}

function traceOne(sheet: Sheet, path: Path2D, segment: Segment): void {
  const end = pixel(sheet, segment.to);
  if (!isLine(segment)) {
    const { centre, radius, start, sweep } = arcOf(segment);
    const pixels = radius / sheet.window.mmPerPixel;
    const middle = pixel(sheet, centre);
    // A canvas counts angles downwards.
    if (pixels > dot) path.arc(middle.x, middle.y, pixels, -start, -(start + sweep), sweep > 0);
  }
  path.lineTo(end.x, end.y);
}

/** A cross of two strokes. */
export function traceCross(path: Path2D, { x, y }: Place, half: number): void {
  path.moveTo(x - half, y - half);
  path.lineTo(x + half, y + half);
  path.moveTo(x - half, y + half);
  path.lineTo(x + half, y - half);
}
