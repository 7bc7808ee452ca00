/** Answers the page's fetches without a server. */

import { message } from "../../src/units/testing";
import type { PreviewInfo } from "../../src/wire/messages";
import { commands } from "./commands";
import { shapes } from "./drawing";

const lines = `' First cut: the outline of a rectangle, 4 by 2 inches, an eighth of an inch deep.
' Cutter 1/4 inch.

IF %(25) = 1 THEN GOTO UNIT_ERROR
SA
MS, 1.5, 0.5
JZ, 0.5
SO, 1, 1
PAUSE 2
J2, 1, 1
MZ, -0.125
MY, 3
MX, 5
MY, 1
MX, 1
JZ, 0.5
SO, 1, 0
J2, 0, 0
END

UNIT_ERROR:
PRINT "This file is written in inches."
END`;

const findings = [
  {
    level: "warning",
    code: "W042",
    file: "",
    line: 9,
    column: 1,
    length: 5,
    message: "The spindle may not be up to speed yet.",
    hint: "Two seconds are short for most spindles.",
  },
];

const inch = 25.4;
const corners = [
  [0, 0, 0.5],
  [1, 1, 0.5],
  [1, 1, -0.125],
  [1, 3, -0.125],
  [5, 3, -0.125],
  [5, 1, -0.125],
  [1, 1, -0.125],
  [1, 1, 0.5],
  [0, 0, 0.5],
];

const info = message<PreviewInfo>({
  origin: [0, 0, 0],
  zero: [0, 0, 0],
  table: [0, 0],
  tableSize: [8 * inch, 6 * inch],
  grid: inch,
  bounds: [
    [inch, inch, -3.175],
    [5 * inch, 3 * inch, -3.175],
  ],
  cutter: 6.35,
  seconds: 31.4,
  cut: 12 * inch,
  jog: 4 * inch,
  moves: corners.length - 1,
  details: [{ tolerance: 0, segments: corners.length - 1, pieces: 1 }],
  toolpaths: [],
  rotary: false,
});

function piece(): ArrayBuffer {
  const n = corners.length - 1;
  const bytes = new ArrayBuffer(8 + 12 * (n + 1) + 13 * n);
  const view = new DataView(bytes);
  view.setUint32(0, n, true);
  corners.flat().forEach((value, k) => {
    view.setFloat32(8 + 4 * k, value * inch, true);
  });
  const at = 8 + 12 * (n + 1);
  for (let k = 0; k < n; k += 1) {
    view.setFloat32(at + 4 * k, (k + 1) * 4, true);
    view.setUint32(at + 4 * (n + k), k + 8, true);
    view.setUint32(at + 4 * (2 * n + k), k, true);
    view.setUint8(at + 12 * n + k, k === 0 || k > 5 ? 0 : 1);
  }
  return bytes;
}

const noPaths = { revision: 1, paths: [], smoothed: [], filtered: [], notes: [] };

/** Answers what the server would. */
export async function answer(address: string): Promise<Response> {
  const path = address.split("?")[0] ?? "";
  if (path === "/api/preview/first") return Response.json(info);
  if (path === "/api/preview/first/0/0") return new Response(piece());
  if (path.startsWith("/api/files/")) return new Response(lines);
  if (path === "/api/language/check") return Response.json({ findings });
  if (path === "/api/language/complete") return Response.json([]);
  if (path === "/api/commands") return Response.json(commands);
  if (path === "/api/drawing/shapes") return Response.json(shapes);
  if (path === "/api/drawing/paths") return Response.json(noPaths);
  return Response.json([]);
}
