/** The paper below the shapes: a grid that fits the zoom, and the origin. */

import { inUnit, type LengthUnit, type Mm, mm, ofUnit, shown } from "../../units/quantity";
import { place } from "../geometry/vec";
import { boxInSight } from "../window";
import { pixel, type Sheet } from "./pen";
import type { Ink } from "./picture";

/** Grid lines are at least so far apart, pixels. */
const leastGap = 14;

/** The distance of grid lines: 1, 2 or 5 times a power of ten of the user's unit, mm. */
export function gridOf(mmPerPixel: number, unit: LengthUnit): Mm {
  const least = inUnit(mm(leastGap * mmPerPixel), unit);
  const power = 10 ** Math.floor(Math.log10(least));
  const factor = [1, 2, 5, 10].find((f) => f * power >= least) ?? 10;
  return ofUnit(shown(factor * power), unit);
}

export function paintPaper(sheet: Sheet, unit: LengthUnit, ink: Ink): void {
  const { pen, size, window } = sheet;
  pen.fillStyle = ink("--view");
  pen.fillRect(0, 0, size.width, size.height);
  const gap = gridOf(window.mmPerPixel, unit);
  pen.lineWidth = 1;
  paintLines(sheet, gap, ink("--draw-grid"));
  paintLines(sheet, gap * 10, ink("--view-grid"));
  paintOrigin(sheet, ink);
}

function paintLines(sheet: Sheet, gap: number, colour: string): void {
  const { pen, size } = sheet;
  const { min, max } = boxInSight(sheet.window, size);
  pen.strokeStyle = colour;
  pen.beginPath();
  for (let x = Math.ceil(min.x / gap) * gap; x <= max.x; x += gap) {
    const at = Math.round(pixel(sheet, place(x, 0)).x) + 0.5;
    pen.moveTo(at, 0);
    pen.lineTo(at, size.height);
  }
  for (let y = Math.ceil(min.y / gap) * gap; y <= max.y; y += gap) {
    const at = Math.round(pixel(sheet, place(0, y)).y) + 0.5;
    pen.moveTo(0, at);
    pen.lineTo(size.width, at);
  }
  pen.stroke();
}

function paintOrigin(sheet: Sheet, ink: Ink): void {
  const { pen } = sheet;
  const { x, y } = pixel(sheet, place(0, 0));
  pen.strokeStyle = ink("--view-axis");
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(x - 8, y);
  pen.lineTo(x + 24, y);
  pen.moveTo(x, y + 8);
  pen.lineTo(x, y - 24);
  pen.stroke();
  pen.fillStyle = ink("--view-axis");
  pen.font = "11px 'Inter Variable', sans-serif";
  pen.fillText("X", x + 27, y + 4);
  pen.fillText("Y", x - 3.5, y - 28);
}
