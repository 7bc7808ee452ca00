/** Paints a job: paths in the colours of their groups with their directions, what is done, what runs. */

import { type GroupName, tokenOf } from "../draw/colours";
import { startAngle } from "../draw/geometry/segment";
import type { Shape } from "../draw/geometry/shape";
import { tracePoint } from "../draw/paint/lines";
import { pixel, type Sheet, strokeDrawn, traceDrawn } from "../draw/paint/pen";
import type { Ink } from "../draw/paint/picture";
import { boxInSight } from "../draw/window";
import { t } from "../words/words";
import { type Plan, type Share, type Standing, shareOf } from "./plan";

/** From so many paths in sight on, their numbers would cover each other. */
const mostNumbers = 150;

/** Paths shorter than this on the screen have no arrow, pixels. */
const leastArrow = 14;

const inkOfGroup = (group: string) => tokenOf(`group-${group as GroupName}`);

/** Everything that stays while the job runs. */
export function paintPlan(sheet: Sheet, plan: Plan, standing: Standing, ink: Ink): void {
  sheet.pen.lineJoin = "round";
  const strokes = new Map<string, { ink: string; width: number; dash: boolean; path: Path2D }>();
  for (const { shape, traversal } of plan.paths) {
    const skipped = shareOf(shape.number, standing) === "skipped";
    const token = skipped ? "--view-axis" : inkOfGroup(shape.group);
    const key = `${token} ${traversal} ${skipped}`;
    const found = strokes.get(key) ?? {
      ink: ink(token),
      width: skipped ? 1 : 2,
      dash: traversal || skipped,
      path: new Path2D(),
    };
    strokes.set(key, found);
    traceOne(found.path, shape, sheet);
  }
  for (const { ink, width, dash, path } of strokes.values())
    strokeDrawn(sheet, path, { ink, width, dash: dash ? [6, 4] : [] });
  paintArrows(sheet, plan, standing, ink);
}

function traceOne(path: Path2D, shape: Shape, { window }: Sheet): void {
  if (shape.segments.length > 0) traceDrawn(path, shape.segments);
  else tracePoint(path, shape, 4 * window.mmPerPixel);
}

/** Paints what changes while it runs: done, running, chosen, under the pointer. */
export function paintProgress(
  sheet: Sheet,
  plan: Plan,
  standing: Standing,
  { hover, ink }: { hover: number | null; ink: Ink },
): void {
  const marked: Partial<Record<Share | "hover", Path2D>> = {};
  const mark = (share: Share | "hover", shape: Shape) => {
    const path = marked[share] ?? new Path2D();
    marked[share] = path;
    traceOne(path, shape, sheet);
  };
  for (const { shape } of plan.paths) {
    const share = shareOf(shape.number, standing);
    if (share === "done" || share === "running") mark(share, shape);
    if (shape.number === hover) mark("hover", shape);
  }
  const look = { done: ["--view-done", 3], running: ["--view-done", 6] } as const;
  for (const share of ["done", "running"] as const) {
    const path = marked[share];
    const [token, width] = look[share];
    if (path) strokeDrawn(sheet, path, { ink: ink(token), width });
  }
  if (marked.hover) strokeDrawn(sheet, marked.hover, { ink: ink("--draw-hover"), width: 5 });
  paintNumbers(sheet, plan, standing, ink);
}

/** An arrow head at each start, in the direction of travel. */
function paintArrows(sheet: Sheet, plan: Plan, standing: Standing, ink: Ink): void {
  const heads = new Map<string, Path2D>();
  for (const shape of inSight(sheet, plan)) {
    const [first] = shape.segments;
    const [wide, high] = [shape.box.max.x - shape.box.min.x, shape.box.max.y - shape.box.min.y];
    if (!first || Math.max(wide, high) / sheet.window.mmPerPixel < leastArrow) continue;
    const skipped = shareOf(shape.number, standing) === "skipped";
    const token = skipped ? "--view-axis" : inkOfGroup(shape.group);
    const path = heads.get(token) ?? new Path2D();
    heads.set(token, path);
    traceArrow(path, pixel(sheet, first.from), -startAngle(first));
  }
  for (const [token, path] of heads) {
    sheet.pen.fillStyle = ink(token);
    sheet.pen.fill(path);
  }
}

function traceArrow(path: Path2D, at: { x: number; y: number }, angle: number): void {
  const point = (far: number, turn: number): [number, number] => [
    at.x + far * Math.cos(angle + turn),
    at.y + far * Math.sin(angle + turn),
  ];
  path.moveTo(...point(14, 0));
  path.lineTo(...point(6, Math.PI / 2));
  path.lineTo(...point(6, -Math.PI / 2));
  path.closePath();
}

function inSight(sheet: Sheet, plan: Plan): Shape[] {
  const { min, max } = boxInSight(sheet.window, sheet.size);
  return plan.paths
    .map(({ shape }) => shape)
    .filter(
      ({ box }) => box.max.x > min.x && box.min.x < max.x && box.max.y > min.y && box.min.y < max.y,
    );
}

/** Numbers in cutting order where there is room for them; those of the start and the running path always. */
function paintNumbers(sheet: Sheet, plan: Plan, standing: Standing, ink: Ink): void {
  const { pen } = sheet;
  const seen = inSight(sheet, plan);
  const few = seen.length <= mostNumbers;
  pen.font = "600 11px 'Inter Variable', sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const { number, vertices } of seen) {
    const [at] = vertices;
    const starts = number === standing.start && standing.start > 1;
    const runs = shareOf(number, standing) === "running";
    if (!at || !(few || starts || runs)) continue;
    const { x, y } = pixel(sheet, at);
    const words = starts ? t("Start {0}", number) : String(number);
    const wide = pen.measureText(words).width + 8;
    const [left, top] = [x - wide - 6, y + 6];
    pen.fillStyle = ink(runs || starts ? "--draw-start" : "--panel");
    pen.beginPath();
    pen.roundRect(left, top, wide, 16, 4);
    pen.fill();
    pen.fillStyle = runs || starts ? ink("--draw-start-text") : ink("--text");
    pen.fillText(words, left + wide / 2, top + 8.5);
  }
}
