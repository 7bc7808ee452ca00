import { expect, it } from "vitest";
import { readPiece } from "./piece";
import { stretches } from "./progress";
import { framePoints } from "./scene/tableLines";

/** A jog to the start, then a cut of 100 mm along X. */
function line() {
  const bytes = new ArrayBuffer(8 + 12 * 3 + 13 * 2);
  const view = new DataView(bytes);
  view.setUint32(0, 2, true);
  new Float32Array(bytes, 8, 9).set([0, 0, 10, 0, 0, 0, 100, 0, 0]);
  new Float32Array(bytes, 44, 2).set([1, 3]);
  new Uint32Array(bytes, 60, 2).set([0, 1]);
  new Uint8Array(bytes, 68, 2).set([0, 1]);
  return [readPiece(bytes)];
}

it("pro_display_progress: what is cut is told from what is not, within the machine's bounds", () => {
  expect(stretches(line(), 1, [50, 0, 0])).toEqual([
    { from: [0, 0, 0], to: [50, 0, 0], made: true },
    { from: [50, 0, 0], to: [100, 0, 0], made: false },
  ]);
  expect(stretches(line(), 1, [75, 0, 0])[0]?.to).toEqual([75, 0, 0]);
  const info = { origin: [0, 0, 0], zero: [0, 0, 0], table: [-300, -200], tableSize: [2500, 1250] };
  const edge = framePoints(info as never).slice(0, 6);
  expect(edge).toEqual([-300, -200, 0, 2200, -200, 0]);
});

it("says nothing while it jogs, when all is made, or when the tool is elsewhere", () => {
  expect(stretches(line(), 0, [0, 0, 5])).toEqual([]);
  expect(stretches(line(), 3, [100, 0, 0])).toEqual([]);
  expect(stretches(line(), 1, [50, 30, 0])).toEqual([]);
});
