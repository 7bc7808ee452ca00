/** The shapes, batched by colour: one path for all lines of a colour. */

import { hueOf, tokenOf } from "../colours";
import { startAngle } from "../geometry/segment";
import type { Shape } from "../geometry/shape";
import { type Box, isEmpty, type Place } from "../geometry/vec";
import type { ViewOptions } from "../options";
import { boxInSight } from "../window";
import { pixel, type Sheet, trace, traceCross } from "./pen";

/** Everything about a drawing that does not move with the mouse. */
export interface Scene {
  readonly shapes: readonly Shape[];
  /** Numbers of closed shapes that cross themselves. */
  readonly crossing: ReadonlySet<number>;
  readonly selected: ReadonlySet<number>;
  /** Groups that are switched off. */
  readonly off: ReadonlySet<string>;
  /** Groups whose tool path lies to the left of travel. */
  readonly leftOf: ReadonlySet<string>;
  readonly box: Box;
  readonly toolPaths: readonly Shape[];
  readonly options: ViewOptions;
}

/** The colour that a token of the theme holds. */
export type Ink = (token: string) => string;

interface Batch {
  readonly path: Path2D;
  readonly dashed: boolean;
  readonly token: string;
}

export function paintShapes(sheet: Sheet, scene: Scene, ink: Ink): void {
  const { pen } = sheet;
  const seen = scene.shapes.filter((shape) => inSight(sheet, shape) && !hidden(scene, shape));
  pen.lineJoin = "round";
  if (scene.options.toolPaths) paintToolPaths(sheet, scene, ink);
  paintSelected(sheet, seen, scene, ink);
  pen.lineWidth = 1.5;
  for (const { path, dashed, token } of batches(sheet, seen, scene)) {
    pen.strokeStyle = ink(token);
    pen.setLineDash(dashed ? [6, 4] : []);
    pen.stroke(path);
  }
  pen.setLineDash([]);
  if (scene.options.vertices) paintVertices(sheet, seen, ink);
  if (scene.options.starts) paintStarts(sheet, seen, scene, ink);
}

export const hidden = (scene: Pick<Scene, "off" | "options">, shape: Shape): boolean =>
  scene.off.has(shape.group) && !scene.options.offDashed;

function inSight(sheet: Sheet, { box }: Shape): boolean {
  const sight = boxInSight(sheet.window, sheet.size);
  const margin = 12 * sheet.window.mmPerPixel;
  return (
    box.max.x >= sight.min.x - margin &&
    box.min.x <= sight.max.x + margin &&
    box.max.y >= sight.min.y - margin &&
    box.min.y <= sight.max.y + margin
  );
}

function batches(sheet: Sheet, shapes: readonly Shape[], scene: Scene): Batch[] {
  const found = new Map<string, Batch>();
  for (const shape of shapes) {
    const dashed = scene.off.has(shape.group);
    const token = tokenOf(
      hueOf(shape, scene.options.groupColours, scene.crossing.has(shape.number)),
    );
    const key = `${token} ${dashed}`;
    const batch = found.get(key) ?? { path: new Path2D(), dashed, token };
    found.set(key, batch);
    traceShape(sheet, batch.path, shape);
  }
  return [...found.values()];
}

/** A shape's segments; a point as a ring with a cross. */
export function traceShape(sheet: Sheet, path: Path2D, shape: Shape): void {
  trace(sheet, path, shape.segments);
  if (shape.segments.length > 0) return;
  for (const vertex of shape.vertices) {
    const at = pixel(sheet, vertex);
    path.moveTo(at.x + 4, at.y);
    path.arc(at.x, at.y, 4, 0, 2 * Math.PI);
    traceCross(path, at, 4);
  }
}

/** A broad band behind what is selected. */
function paintSelected(sheet: Sheet, shapes: readonly Shape[], scene: Scene, ink: Ink): void {
  const path = new Path2D();
  for (const shape of shapes) if (scene.selected.has(shape.number)) traceShape(sheet, path, shape);
  sheet.pen.strokeStyle = ink("--draw-selected");
  sheet.pen.lineWidth = 7;
  sheet.pen.stroke(path);
}

function paintToolPaths(sheet: Sheet, { toolPaths }: Scene, ink: Ink): void {
  const path = new Path2D();
  for (const shape of toolPaths) if (inSight(sheet, shape)) traceShape(sheet, path, shape);
  sheet.pen.strokeStyle = ink("--draw-toolpath");
  sheet.pen.lineWidth = 1;
  sheet.pen.stroke(path);
}

function paintVertices(sheet: Sheet, shapes: readonly Shape[], ink: Ink): void {
  const path = new Path2D();
  for (const { vertices } of shapes) {
    for (const vertex of vertices) traceCross(path, pixel(sheet, vertex), 3);
  }
  sheet.pen.strokeStyle = ink("--text");
  sheet.pen.lineWidth = 1;
  sheet.pen.stroke(path);
}

/** Where each shape begins: an arrow along the first segment, with a half disc on the cutting side. */
function paintStarts(sheet: Sheet, shapes: readonly Shape[], scene: Scene, ink: Ink): void {
  const [arrows, sides] = [new Path2D(), new Path2D()];
  for (const shape of shapes) {
    const [first] = shape.segments;
    if (!first) continue;
    const at = pixel(sheet, first.from);
    const angle = -startAngle(first);
    traceArrow(arrows, at, angle);
    traceSide(sides, at, angle, scene.leftOf.has(shape.group));
  }
  sheet.pen.lineWidth = 1;
  sheet.pen.strokeStyle = ink("--draw-start-edge");
  sheet.pen.fillStyle = ink("--draw-start");
  for (const path of [sides, arrows]) {
    sheet.pen.fill(path);
    sheet.pen.stroke(path);
  }
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

/** A half disc; canvas angles grow clockwise, so the right side comes first. */
function traceSide(path: Path2D, at: Place, angle: number, left: boolean): void {
  const turned = left ? angle + Math.PI : angle;
  path.moveTo(at.x + 5 * Math.cos(turned), at.y + 5 * Math.sin(turned));
  path.arc(at.x, at.y, 5, turned, turned + Math.PI);
  path.closePath();
}

/** The bounds of the drawing, dashed green. */
export function paintBounds(sheet: Sheet, box: Box, ink: Ink): void {
  if (isEmpty(box)) return;
  const [a, b] = [pixel(sheet, box.min), pixel(sheet, box.max)];
  sheet.pen.setLineDash([5, 4]);
  sheet.pen.lineWidth = 1;
  sheet.pen.strokeStyle = ink("--draw-bounds");
  sheet.pen.strokeRect(a.x, b.y, b.x - a.x, a.y - b.y);
  sheet.pen.setLineDash([]);
}
