/** Paints the machine round the drawing. */

import { t } from "../../words/words";
import type { TableItem } from "../table";
import { pixel, type Sheet } from "./pen";
import type { Ink } from "./picture";

export function paintTable(sheet: Sheet, items: readonly TableItem[], ink: Ink): void {
  for (const item of items) {
    if (item.kind === "bounds") paintReach(sheet, item.box, ink);
    else paintSpot(sheet, item, ink);
  }
}

function paintReach(sheet: Sheet, box: Extract<TableItem, { kind: "bounds" }>["box"], ink: Ink) {
  const [a, b] = [pixel(sheet, box.min), pixel(sheet, box.max)];
  sheet.pen.strokeStyle = ink("--view-axis");
  sheet.pen.lineWidth = 2;
  sheet.pen.strokeRect(a.x, b.y, b.x - a.x, a.y - b.y);
}

type Spot = Exclude<TableItem, { kind: "bounds" }>;

/** Names, and where they stand, so that spots in one place can still be read. */
const names: Record<Spot["kind"], readonly [string, number, number]> = {
  home: [t("Home"), -42, 8],
  origin: [t("Origin"), 9, 8],
  finish: [t("Finish"), 9, -20],
  tool: ["", 0, 0],
};

/** A cross in a ring, with its name; the tool as a filled disc. */
function paintSpot(sheet: Sheet, { kind, at }: Spot, ink: Ink): void {
  const { pen } = sheet;
  const { x, y } = pixel(sheet, at);
  const colour = ink(kind === "tool" ? "--view-tool" : "--text");
  pen.strokeStyle = colour;
  pen.fillStyle = colour;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.arc(x, y, 5, 0, 2 * Math.PI);
  if (kind === "tool") pen.fill();
  pen.moveTo(x - 10, y);
  pen.lineTo(x + 10, y);
  pen.moveTo(x, y - 10);
  pen.lineTo(x, y + 10);
  pen.stroke();
  pen.font = "600 11px 'Inter Variable', sans-serif";
  pen.textAlign = "left";
  pen.textBaseline = "top";
  const [words, across, down] = names[kind];
  pen.fillText(words, x + across, y + down);
}
