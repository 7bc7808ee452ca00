/** Paints points that are being digitized: discs on lines, diamonds on arcs, a ring round the current one. */

import { pixel, type Sheet, strokeDrawn, traceDrawn } from "../draw/paint/pen";
import type { Ink } from "../draw/paint/picture";
import type { DigitizedItem, DigitizedMark } from "./points";

export function paintDigitized(sheet: Sheet, item: DigitizedItem | null, ink: Ink): void {
  if (!item) return;
  const path = new Path2D();
  traceDrawn(path, item.path.segments);
  strokeDrawn(sheet, path, { ink: ink("--draw-digitized"), width: 2.5 });
  for (const mark of item.points) paintMark(sheet, mark, ink);
}

function paintMark(sheet: Sheet, { at, arc, current }: DigitizedMark, ink: Ink): void {
  const { pen } = sheet;
  const { x, y } = pixel(sheet, at);
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
