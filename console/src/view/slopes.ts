/**
 * Slope of a field of heights, for its shading.
 *
 * Cells about a place count too, near ones most: the slope of a wall that follows the grid in steps is that of
 * the curve which was cut, and a round wall shows no stripes.
 */

/** Cells to each side that count. */
const reach = 8;
const offsets = Array.from({ length: 2 * reach + 1 }, (_, n) => n - reach);
const bell = offsets.map((away) => Math.exp((-away * away) / 32));
const sum = (values: readonly number[]) => values.reduce((all, value) => all + value, 0);
const even = bell.map((weight) => weight / sum(bell));
const spread = sum(bell.map((weight, n) => weight * (offsets[n] ?? 0) ** 2));
const steep = bell.map((weight, n) => (weight * (offsets[n] ?? 0)) / spread);

interface Grid {
  readonly columns: number;
  readonly rows: number;
}

/** Weighs every cell with those before and behind it; beyond the border it goes on as it ends. */
function weigh(values: Float32Array, weights: readonly number[], across: boolean, grid: Grid) {
  const { columns, rows } = grid;
  const weighed = new Float32Array(values.length);
  const [length, lines] = across ? [columns, rows] : [rows, columns];
  const [step, next] = across ? [1, columns] : [columns, 1];
  for (let line = 0; line < lines; line += 1) {
    for (let k = 0; k < length; k += 1) {
      let value = 0;
      for (let n = 0; n < weights.length; n += 1) {
        const at = Math.min(Math.max(k + n - reach, 0), length - 1);
        value += (weights[n] ?? 0) * (values[line * next + at * step] ?? 0);
      }
      weighed[line * next + k * step] = value;
    }
  }
  return weighed;
}

/** The slope along X and along Y of each cell, one after the other: height for each cell of the way. */
export function slopesOf(heights: Float32Array, grid: Grid, into: Float32Array): void {
  const alongX = weigh(weigh(heights, steep, true, grid), even, false, grid);
  const alongY = weigh(weigh(heights, even, true, grid), steep, false, grid);
  for (let n = 0; n < heights.length; n += 1) {
    into[2 * n] = alongX[n] ?? 0;
    into[2 * n + 1] = alongY[n] ?? 0;
  }
}
