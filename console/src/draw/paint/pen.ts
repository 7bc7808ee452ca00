/** Lines and arcs on a canvas, from places of the drawing. */

import { arcOf, isLine, type Segment } from "../geometry/segment";
import type { Place } from "../geometry/vec";
import { type Size, toPixels, type Window } from "../window";

export interface Sheet {
  readonly pen: CanvasRenderingContext2D;
  readonly window: Window;
  readonly size: Size;
}

/** Pixels of the canvas in one of the page. */
const ratioOf = (): number => Math.min(devicePixelRatio, 2);

/** Prepares a canvas for a picture of that size, sharp on screens with small pixels. */
export function sheetOn(canvas: HTMLCanvasElement, window: Window, size: Size): Sheet | null {
  const pen = canvas.getContext("2d");
  if (!pen) return null;
  const ratio = ratioOf();
  const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
  // Setting the size makes a new surface, which costs more than a picture.
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { pen, window, size };
}

export const pixel = ({ window, size }: Sheet, at: Place): Place => toPixels(window, size, at);

/** The change of place from the drawing to pixels, as a canvas takes it. */
export const drawingToPixels = ({ window, size }: Omit<Sheet, "pen">): DOMMatrix => {
  const s = 1 / window.mmPerPixel;
  const [x, y] = [size.width / 2 - window.middle.x * s, size.height / 2 + window.middle.y * s];
  return new DOMMatrix([s, 0, 0, -s, x, y]);
};

/** Adds segments that follow each other to a path in places of the drawing. */
export function traceDrawn(path: Path2D, segments: readonly Segment[]): void {
  const first = segments[0];
  if (!first) return;
  path.moveTo(first.from.x, first.from.y);
  for (const segment of segments) {
    if (!isLine(segment)) {
      const { centre, radius, start, sweep } = arcOf(segment);
      path.arc(centre.x, centre.y, radius, start, start + sweep, sweep < 0);
    }
    path.lineTo(segment.to.x, segment.to.y);
  }
}

/** Strokes a path that is in places of the drawing; widths and dashes are pixels. */
export function strokeDrawn(
  sheet: Sheet,
  path: Path2D,
  { ink, width, dash = [] }: { ink: string; width: number; dash?: readonly number[] },
): void {
  const { pen, window } = sheet;
  const { a, b, c, d, e, f } = drawingToPixels(sheet);
  pen.save();
  pen.transform(a, b, c, d, e, f);
  pen.strokeStyle = ink;
  pen.lineWidth = width * window.mmPerPixel;
  pen.setLineDash(dash.map((length) => length * window.mmPerPixel));
  pen.stroke(path);
  pen.restore();
}

/** Shapes smaller than this are drawn as one dot, pixels. */
const dot = 0.6;

/** Adds segments that follow each other to a path in pixels. */
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
