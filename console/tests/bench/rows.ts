/** Long part files that are measured. */

import { closeSync, openSync, writeSync } from "node:fs";
import { join } from "node:path";

/** Writes a part file into a folder: a surface cut in rows, so many short moves. */
export function writeRows(folder: string, name: string, segments: number): void {
  const file = openSync(join(folder, name), "w");
  const side = Math.round(Math.sqrt(segments));
  writeSync(file, "SA\nMS,2,1\nJZ,0.5\n");
  let lines: string[] = [];
  for (let n = 0; n < segments; n += 1) {
    const [row, column] = [Math.floor(n / side), n % side];
    const across = row % 2 === 0 ? column : side - 1 - column;
    const [x, y] = [(across / side) * 20, (row / side) * 20];
    const z = -0.2 - 0.15 * Math.sin(x * 1.7) * Math.cos(y * 1.3);
    lines.push(`M3,${x.toFixed(4)},${y.toFixed(4)},${z.toFixed(4)}`);
    if (lines.length === 10_000) {
      writeSync(file, `${lines.join("\n")}\n`);
      lines = [];
    }
  }
  writeSync(file, `${lines.join("\n")}\nEND\n`);
  closeSync(file);
}
