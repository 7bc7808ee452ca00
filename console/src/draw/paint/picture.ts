/** Paints the picture of a drawing: lines of a colour together, then marks. */

import type { Place } from "../geometry/vec";
import type { Mark, Picture, Stroke } from "../picture";
import { boxInSight } from "../window";
import { apart } from "./crowd";
import { linesOf } from "./lines";
import { pixel, type Sheet, strokeDrawn, traceCross } from "./pen";

/** The colour that a token of the theme holds. */
export type Ink = (token: string) => string;

/** Widths in pixels. */
const widths: Record<Stroke["kind"], number> = {
  shape: 1.5,
  selected: 7,
  smoothed: 1.5,
  path: 1,
  rough: 1,
  traversal: 1,
};

const dashed = [6, 4];

export function paintPicture(sheet: Sheet, picture: Picture, ink: Ink): void {
  sheet.pen.lineJoin = "round";
  for (const { kind, token, dash, path } of linesOf(picture, sheet)) {
    const width = widths[kind];
    strokeDrawn(sheet, path, { ink: ink(token), width, dash: dash ? dashed : [] });
  }
  for (const kind of ["bbox", "vertex", "filtered", "start"] as const) {
    const marks = picture.marks.filter((mark) => mark.kind === kind);
    if (marks.length > 0) paintMarks(sheet, marks, ink);
  }
}

function paintMarks(sheet: Sheet, marks: readonly Mark[], ink: Ink): void {
  const { pen } = sheet;
  const [first] = marks;
  pen.lineWidth = 1;
  pen.setLineDash(first?.kind === "bbox" ? [5, 4] : []);
  const seen = apart(marksInSight(sheet, marks), (at) => pixel(sheet, at));
  for (const some of chunks(seen, together)) {
    const [paths, fills] = [new Path2D(), new Path2D()];
    for (const mark of some) {
      if (mark.kind === "bbox") traceBounds(sheet, paths, mark);
      else traceMark(sheet, mark.kind === "start" ? fills : paths, mark);
    }
    pen.strokeStyle = ink(first?.ink ?? "--text");
    pen.stroke(paths);
    pen.fillStyle = ink("--draw-start");
    pen.strokeStyle = ink("--draw-start-edge");
    pen.fill(fills);
    pen.stroke(fills);
  }
  pen.setLineDash([]);
}

/** A browser takes the square of the time for a path of more closed pieces. */
const together = 400;

function chunks<T>(all: readonly T[], size: number): T[][] {
  const count = Math.ceil(all.length / size);
  return Array.from({ length: count }, (_, n) => all.slice(n * size, (n + 1) * size));
}

function marksInSight(sheet: Sheet, marks: readonly Mark[]): readonly Mark[] {
  const inSight = sightOf(sheet);
  return marks.filter((mark) => mark.kind === "bbox" || inSight(mark.at));
}

function sightOf({ window, size }: Sheet): (at: Place) => boolean {
  const { min, max } = boxInSight(window, size);
  const margin = 20 * window.mmPerPixel;
  return ({ x, y }) =>
    x > min.x - margin && x < max.x + margin && y > min.y - margin && y < max.y + margin;
}

function traceBounds(sheet: Sheet, path: Path2D, { box }: Extract<Mark, { kind: "bbox" }>): void {
  const [a, b] = [pixel(sheet, box.min), pixel(sheet, box.max)];
  path.rect(a.x, b.y, b.x - a.x, a.y - b.y);
}

function traceMark(sheet: Sheet, path: Path2D, mark: Exclude<Mark, { kind: "bbox" }>): void {
  const at = pixel(sheet, mark.at);
  if (mark.kind !== "start") {
    traceCross(path, at, mark.kind === "filtered" ? 4 : 3);
    return;
  }
  // A canvas counts angles downwards.
  const angle = (-mark.angle * Math.PI) / 180;
  traceSide(path, at, angle, mark.side === "left");
  traceArrow(path, at, angle);
}

/** An arrow head, pixels. */
function traceArrow(path: Path2D, at: Place, angle: number): void {
  const point = (far: number, turn: number): [number, number] => [
    at.x + far * Math.cos(angle + turn),
    at.y + far * Math.sin(angle + turn),
  ];
  path.moveTo(...point(19, 0));
  path.lineTo(...point(10, 0.5));
  path.lineTo(...point(10, -0.5));
  path.closePath();
}

/** A half disc on the side of the tool; canvas angles grow clockwise, so the right side comes first. */
function traceSide(path: Path2D, at: Place, angle: number, left: boolean): void {
  const turned = left ? angle + Math.PI : angle;
  path.moveTo(at.x + 5 * Math.cos(turned), at.y + 5 * Math.sin(turned));
  path.arc(at.x, at.y, 5, turned, turned + Math.PI);
  path.closePath();
}
