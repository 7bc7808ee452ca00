/** Draws over the tool path: the tool, the working zero, a scale. */

import { inUnit, type LengthUnit, mm, ofUnit, type Shown, shown } from "../units/quantity";
import { type Camera, project, type Size, type Vec3 } from "./camera";
import { paintRecorded, type Recorded } from "./recorded";
import type { Palette } from "./scene/palette";
import { paintTyped, type TypedMarks } from "./typedInk";

export interface Marks {
  /** Tip of the tool, mm from the origin of the preview. */
  readonly tool: Vec3 | undefined;
  readonly zero: Vec3 | undefined;
  /** The part of the present cut that is made. */
  readonly made: { readonly from: Vec3; readonly to: Vec3 } | undefined;
  /** The typed moves. */
  readonly typed: TypedMarks;
  /** Points that are being digitized. */
  readonly recorded: Recorded | undefined;
  /** Diameter of the cutter, mm. */
  readonly cutter: number;
  /** With which the scale is labelled. */
  readonly unit: LengthUnit;
}

export function paintMarks(
  canvas: HTMLCanvasElement,
  size: Size,
  camera: Camera,
  marks: Marks,
  palette: Palette,
): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const ratio = Math.min(devicePixelRatio, 2);
  canvas.width = size.width * ratio;
  canvas.height = size.height * ratio;
  context.scale(ratio, ratio);
  paintScale(context, size, camera, marks.unit, palette);
  paintTyped(context, size, camera, marks.typed, palette);
  if (marks.made) paintMade(context, size, camera, marks.made, palette);
  if (marks.zero) paintZero(context, project(camera, marks.zero, size), palette);
  if (marks.tool) paintTool(context, size, camera, marks.tool, marks.cutter, palette);
  // The tool stands at the point that was recorded last: its mark is seen all the same.
  if (marks.recorded) paintRecorded(context, size, camera, marks.recorded);
}

type Pen = CanvasRenderingContext2D;
type At = { x: number; y: number };

/** The line behind the tool, as wide as the path. */
function paintMade(
  pen: Pen,
  size: Size,
  camera: Camera,
  { from, to }: NonNullable<Marks["made"]>,
  palette: Palette,
): void {
  const [a, b] = [project(camera, from, size), project(camera, to, size)];
  pen.strokeStyle = palette.done;
  pen.lineWidth = 2.5;
  pen.beginPath();
  pen.moveTo(a.x, a.y);
  pen.lineTo(b.x, b.y);
  pen.stroke();
}

/** The quartered disc of a datum. */
function paintZero(pen: Pen, { x, y }: At, palette: Palette): void {
  const radius = 6;
  pen.fillStyle = palette.paper;
  pen.strokeStyle = palette.text;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
  pen.fillStyle = palette.text;
  for (const quarter of [0, Math.PI]) {
    pen.beginPath();
    pen.moveTo(x, y);
    pen.arc(x, y, radius, quarter, quarter + Math.PI / 2);
    pen.fill();
  }
}

/** Least half width of the tool in the picture, so that it is always seen; pixels. */
const leastHalf = 6;

/** A cutter with its tip at the place, and a cross through the tip. */
function paintTool(
  pen: Pen,
  size: Size,
  camera: Camera,
  tip: Vec3,
  cutter: number,
  palette: Palette,
): void {
  const at = project(camera, tip, size);
  const half = Math.max(cutter / 2 / camera.mmPerPixel, leastHalf);
  const tilt = Math.sin(camera.tiltRad);
  pen.strokeStyle = palette.tool;
  pen.lineWidth = 1;
  pen.setLineDash([5, 4]);
  pen.beginPath();
  pen.moveTo(at.x - half - 26, at.y);
  pen.lineTo(at.x + half + 26, at.y);
  pen.moveTo(at.x, at.y + half + 26);
  pen.lineTo(at.x, at.y - half - 26);
  pen.stroke();
  pen.setLineDash([]);
  paintShaft(pen, at, half, half * Math.cos(camera.tiltRad), tilt * half * 6, palette);
}

/** A cylinder seen obliquely: `flat` is the half height of its round ends. */
function paintShaft(
  pen: Pen,
  { x, y }: At,
  half: number,
  flat: number,
  height: number,
  palette: Palette,
): void {
  const round = Math.max(Math.abs(flat), 1);
  pen.lineWidth = 2;
  pen.fillStyle = `color-mix(in srgb, ${palette.done} 35%, transparent)`;
  pen.beginPath();
  pen.ellipse(x, y, half, round, 0, 0, Math.PI);
  pen.ellipse(x, y - height, half, round, 0, Math.PI, 2 * Math.PI);
  pen.closePath();
  pen.fill();
  pen.stroke();
  pen.beginPath();
  pen.ellipse(x, y - height, half, round, 0, 0, 2 * Math.PI);
  pen.stroke();
  pen.fillStyle = palette.tool;
  pen.beginPath();
  pen.arc(x, y, 2.5, 0, 2 * Math.PI);
  pen.fill();
}

/** Widest that the bar of the scale may be, pixels. */
const widestScale = 130;

/** The longest round length that fits: 1, 2 or 5 times a power of ten. */
export function roundLength(atMost: Shown): Shown {
  const power = 10 ** Math.floor(Math.log10(atMost));
  const factor = [5, 2, 1].find((f) => f * power <= atMost) ?? 1;
  return shown(factor * power);
}

function paintScale(
  pen: Pen,
  size: Size,
  camera: Camera,
  unit: Marks["unit"],
  palette: Palette,
): void {
  const length = roundLength(inUnit(mm(widestScale * camera.mmPerPixel), unit));
  const width = ofUnit(length, unit) / camera.mmPerPixel;
  const [x, y] = [size.width - width - 14, size.height - 14];
  pen.strokeStyle = palette.text;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(x, y - 5);
  pen.lineTo(x, y);
  pen.lineTo(x + width, y);
  pen.lineTo(x + width, y - 5);
  pen.stroke();
  pen.fillStyle = palette.text;
  pen.font = '600 12px "Inter Variable", sans-serif';
  pen.textAlign = "center";
  pen.fillText(`${Number(length.toPrecision(3))} ${unit.linear}`, x + width / 2, y - 7);
}
