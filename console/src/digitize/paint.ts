/** Paints points that are being digitized: discs on lines, diamonds on arcs, a ring round the current one. */

import { pixel, type Sheet, strokeDrawn, traceDrawn } from "../draw/paint/pen";
import type { Ink } from "../draw/paint/picture";
import type { DigitizedItem, DigitizedMark } from "./points";

export function paintDigitized(sheet: Sheet, item: DigitizedItem | null, ink: Ink): void {
  if (!item) return;
  const path = new Path2D();
  traceDrawn(path, item.path.segments);
  strokeDrawn(sheet, path, { ink: ink("--draw-digitized"), width: 2.5 });
  for (const mark of item.points) paintMark(sheet.pen, pixel(sheet, mark.at), mark, ink);
}

/** A point at a pixel. */
export function paintMark(
  pen: CanvasRenderingContext2D,
  { x, y }: { readonly x: number; readonly y: number },
  { arc, current }: Pick<DigitizedMark, "arc" | "current">,
  ink: Ink,
): void {
  pen.beginPath();
  if (arc) {
    pen.moveTo(x, y - 6);
    pen.lineTo(x + 6, y);
    pen.lineTo(x, y + 6);
    pen.lineTo(x - 6, y);
    pen.closePath();
  } else {
    pen.arc(x, y, 4.5, 0, 2 * Math.PI);
  }
  pen.fillStyle = ink(current ? "--draw-digitized-current" : "--draw-digitized");
  pen.fill();
  if (!current) return;
  pen.strokeStyle = ink("--draw-digitized-current");
  pen.lineWidth = 2;
  pen.setLineDash([]);
  pen.beginPath();
  pen.arc(x, y, 10, 0, 2 * Math.PI);
  pen.stroke();
}
