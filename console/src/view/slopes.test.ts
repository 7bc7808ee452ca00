import { expect, it } from "vitest";
import { slopesOf } from "./slopes";

const grid = { columns: 101, rows: 101 };

/** The slopes of a field whose heights follow from column and row. */
function slopes(height: (column: number, row: number) => number): Float32Array {
  const cells = grid.columns * grid.rows;
  const heights = Float32Array.from({ length: cells }, (_, n) =>
    height(n % grid.columns, Math.floor(n / grid.columns)),
  );
  const into = new Float32Array(2 * cells);
  slopesOf(heights, grid, into);
  return into;
}
const at = (all: Float32Array, column: number, row: number) => {
  const n = 2 * (row * grid.columns + column);
  return [all[n] ?? 0, all[n + 1] ?? 0] as const;
};

it("an inclined plane slopes alike everywhere, a level one nowhere", () => {
  const [x, y] = at(
    slopes((column, row) => 0.5 * column - 2 * row),
    40,
    60,
  );
  expect(x).toBeCloseTo(0.5, 4);
  expect(y).toBeCloseTo(-2, 4);
  expect(
    at(
      slopes(() => -3),
      0,
      100,
    ).map((slope) => Math.abs(slope)),
  ).toEqual([expect.closeTo(0, 5), expect.closeTo(0, 5)]);
});

it("the wall of a round hole slopes to its middle all around, whatever steps it has", () => {
  const hole = slopes((column, row) => (Math.hypot(column - 50, row - 50) < 30 ? -10 : 0));
  for (let degrees = 0; degrees < 360; degrees += 5) {
    const angle = (degrees * Math.PI) / 180;
    const column = Math.round(50 + 30 * Math.cos(angle));
    const row = Math.round(50 + 30 * Math.sin(angle));
    const [x, y] = at(hole, column, row);
    const outwards = Math.atan2(row - 50, column - 50);
    const off = Math.atan2(y, x) - outwards;
    expect(Math.cos(off), `${degrees} degrees`).toBeGreaterThan(Math.cos(Math.PI / 18));
  }
});

it("a straight wall slopes across its cut at every slant, whatever steps it has", () => {
  for (let degrees = 0; degrees < 360; degrees += 5) {
    const angle = (degrees * Math.PI) / 180;
    const [over, up] = [Math.cos(angle), Math.sin(angle)];
    const beyond = (column: number, row: number) => (column - 50) * over + (row - 50) * up;
    const wall = slopes((column, row) => (beyond(column, row) < 0 ? -10 : 0));
    for (let along = -25; along <= 25; along += 1) {
      const [x, y] = at(wall, Math.round(50 - along * up), Math.round(50 + along * over));
      const off = Math.atan2(y, x) - angle;
      expect(Math.cos(off), `${degrees} degrees at ${along}`).toBeGreaterThan(
        Math.cos(Math.PI / 25),
      );
    }
  }
});
