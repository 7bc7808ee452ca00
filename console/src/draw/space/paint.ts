/** Paints the drawing as it is seen in space. */

import { type Camera, project, type Size, type Vec3 } from "../../view/camera";
import type { Ink } from "../paint/picture";
import type { Item } from "./items";

interface Paper {
  readonly pen: CanvasRenderingContext2D;
  readonly camera: Camera;
  readonly size: Size;
}

export function paintItems(paper: Paper, items: readonly Item[], ink: Ink): void {
  const { pen, size } = paper;
  pen.fillStyle = ink("--view");
  pen.fillRect(0, 0, size.width, size.height);
  pen.lineJoin = "round";
  for (const [key, group] of batches(items)) {
    const path = new Path2D();
    for (const line of group) trace(paper, path, line);
    const [token = "", dash] = key.split(" ");
    pen.strokeStyle = ink(token);
    pen.lineWidth = token.startsWith("--draw-level") ? 1 : 1.5;
    pen.setLineDash(dash === "true" ? [6, 4] : []);
    pen.stroke(path);
  }
  pen.setLineDash([]);
  for (const item of items) {
    if (item.kind === "level") paintName(paper, item, ink);
    if (item.kind === "machine") paintTool(paper, item.at, ink(item.ink));
  }
}

/** Lines of the same look together, in the order in which they lie over each other. */
function batches(items: readonly Item[]): Map<string, (readonly Vec3[])[]> {
  const found = new Map<string, (readonly Vec3[])[]>();
  for (const item of items) {
    if (item.kind === "machine") continue;
    const key = `${item.ink} ${item.kind === "level" ? false : item.dash}`;
    const lines = found.get(key) ?? [];
    found.set(key, lines);
    lines.push(item.line);
  }
  return found;
}

/** A point is a ring of this radius, pixels. */
const pointRadius = 3;

function ring(path: Path2D, x: number, y: number): void {
  path.moveTo(x + pointRadius, y);
  path.arc(x, y, pointRadius, 0, 2 * Math.PI);
}

function trace({ camera, size }: Paper, path: Path2D, line: readonly Vec3[]): void {
  line.forEach((at, n) => {
    const { x, y } = project(camera, at, size);
    if (line.length === 1) ring(path, x, y);
    else if (n === 0) path.moveTo(x, y);
    else path.lineTo(x, y);
  });
}

/** The name of a level, at the corner of its frame that lies farthest to the right. */
function paintName(
  { pen, camera, size }: Paper,
  { name, line, ink: token }: Extract<Item, { kind: "level" }>,
  ink: Ink,
): void {
  const corners = line.map((at) => project(camera, at, size));
  const [first] = [...corners].sort((a, b) => b.x - a.x);
  if (!first) return;
  pen.fillStyle = ink(token);
  pen.font = "600 11px 'Inter Variable', sans-serif";
  pen.textAlign = "left";
  pen.textBaseline = "middle";
  pen.fillText(name, Math.min(first.x + 6, size.width - 56), first.y);
}

/** The tool: a cone that stands on its tip. */
function paintTool({ pen, camera, size }: Paper, at: Vec3, colour: string): void {
  const { x, y } = project(camera, at, size);
  pen.fillStyle = colour;
  pen.strokeStyle = colour;
  pen.lineWidth = 1;
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x - 6, y - 18);
  pen.lineTo(x + 6, y - 18);
  pen.closePath();
  pen.fill();
  pen.beginPath();
  pen.moveTo(x - 14, y);
  pen.lineTo(x + 14, y);
  pen.stroke();
}
