/** Paints what moves with the mouse: highlight, ghost of a change, region, snaps. */

import type { Segment } from "../geometry/segment";
import type { Shape } from "../geometry/shape";
import type { Place } from "../geometry/vec";
import type { Ghost } from "../tools/tool";
import { traceShape } from "./lines";
import { pixel, type Sheet, strokeDrawn, trace } from "./pen";
import type { Ink } from "./picture";

export interface Overlay {
  readonly hovered: readonly Shape[];
  readonly picked: readonly Shape[];
  /** Vertices that were picked. */
  readonly marks: readonly Place[];
  /** Numbers beside the shapes that were picked, in order. */
  readonly numbered: boolean;
  readonly ghost: Ghost;
  readonly ghostShapes: readonly Shape[];
  /** Segments of the path so far, and the one to the mouse. */
  readonly path: readonly Segment[];
  readonly region: { readonly from: Place; readonly to: Place } | null;
  /** Place that a click would give, when a snap found another than the mouse's. */
  readonly snap: Place | null;
  readonly pointer: Place | null;
  /** The selection radius is drawn while a snap is armed, pixels. */
  readonly radius: number | null;
  readonly square: Place | null;
}

export function paintOverlay(sheet: Sheet, overlay: Overlay, ink: Ink): void {
  const { pen, size } = sheet;
  pen.clearRect(0, 0, size.width, size.height);
  paintBand(sheet, overlay.picked, ink("--draw-selected"), 7);
  paintBand(sheet, overlay.hovered, ink("--draw-hover"), 3);
  paintGhost(sheet, overlay, ink);
  for (const mark of overlay.marks) paintMark(sheet, mark, ink);
  if (overlay.numbered) paintNumbers(sheet, overlay.picked, ink);
  if (overlay.region) paintRegion(sheet, overlay.region.from, overlay.region.to, ink);
  if (overlay.square) paintSquare(sheet, overlay.square, ink);
  if (overlay.pointer && overlay.radius !== null)
    paintRadius(sheet, overlay.pointer, overlay.radius, ink);
  if (overlay.snap) paintSnap(sheet, overlay.snap, ink);
}

function paintBand(sheet: Sheet, shapes: readonly Shape[], ink: string, width: number): void {
  if (shapes.length === 0) return;
  const path = new Path2D();
  for (const shape of shapes) traceShape(path, shape, sheet.window.mmPerPixel);
  strokeDrawn(sheet, path, { ink, width });
}

function paintGhost(sheet: Sheet, { ghost, ghostShapes, path }: Overlay, ink: Ink): void {
  const { pen } = sheet;
  const drawn = new Path2D();
  trace(sheet, drawn, path);
  if (ghost.kind === "segments") trace(sheet, drawn, ghost.segments);
  pen.strokeStyle = ink("--draw-ghost");
  pen.lineWidth = 1.5;
  pen.stroke(drawn);
  if (ghost.kind !== "moved") return;
  const still = new Path2D();
  for (const shape of ghostShapes) traceShape(still, shape, sheet.window.mmPerPixel);
  const moved = new Path2D();
  moved.addPath(still, new DOMMatrix([...ghost.by]));
  strokeDrawn(sheet, moved, { ink: ink("--draw-ghost"), width: 1.5 });
}

function paintNumbers(sheet: Sheet, picked: readonly Shape[], ink: Ink): void {
  const { pen } = sheet;
  pen.font = "600 12px 'Inter Variable', sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  picked.forEach(({ vertices }, n) => {
    const first = vertices[0];
    if (!first) return;
    const { x, y } = pixel(sheet, first);
    pen.fillStyle = ink("--accent");
    pen.beginPath();
    pen.arc(x, y, 10, 0, 2 * Math.PI);
    pen.fill();
    pen.fillStyle = ink("--accent-text");
    pen.fillText(String(n + 1), x, y);
  });
}

/** From the left: shapes wholly inside; from the right, dashed: those it touches too. */
function paintRegion(sheet: Sheet, from: Place, to: Place, ink: Ink): void {
  const { pen } = sheet;
  const [a, b] = [pixel(sheet, from), pixel(sheet, to)];
  pen.strokeStyle = ink("--accent");
  pen.fillStyle = ink("--draw-region");
  pen.lineWidth = 1;
  pen.setLineDash(to.x < from.x ? [5, 4] : []);
  pen.fillRect(a.x, a.y, b.x - a.x, b.y - a.y);
  pen.strokeRect(a.x, a.y, b.x - a.x, b.y - a.y);
  pen.setLineDash([]);
}

export const squareInk = "--draw-anticlockwise";

/** A blue cross-hair through the base point while picks are square to it. */
function paintSquare(sheet: Sheet, base: Place, ink: Ink): void {
  const { pen, size } = sheet;
  const { x, y } = pixel(sheet, base);
  pen.strokeStyle = ink(squareInk);
  pen.lineWidth = 1;
  pen.beginPath();
  pen.moveTo(x, 0);
  pen.lineTo(x, size.height);
  pen.moveTo(0, y);
  pen.lineTo(size.width, y);
  pen.stroke();
}

function paintRadius(sheet: Sheet, pointer: Place, radius: number, ink: Ink): void {
  const { x, y } = pixel(sheet, pointer);
  sheet.pen.strokeStyle = ink("--draw-clockwise");
  sheet.pen.lineWidth = 1;
  sheet.pen.beginPath();
  sheet.pen.arc(x, y, radius, 0, 2 * Math.PI);
  sheet.pen.stroke();
}

/** A square round a vertex that was picked. */
function paintMark(sheet: Sheet, at: Place, ink: Ink): void {
  const { pen } = sheet;
  const { x, y } = pixel(sheet, at);
  pen.strokeStyle = ink("--draw-selected");
  pen.lineWidth = 2;
  pen.strokeRect(x - 5, y - 5, 10, 10);
}

/** A small diamond where the pick would be. */
function paintSnap(sheet: Sheet, at: Place, ink: Ink): void {
  const { pen } = sheet;
  const { x, y } = pixel(sheet, at);
  pen.strokeStyle = ink("--draw-clockwise");
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(x - 6, y);
  pen.lineTo(x, y - 6);
  pen.lineTo(x + 6, y);
  pen.lineTo(x, y + 6);
  pen.closePath();
  pen.stroke();
}
