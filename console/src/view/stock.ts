/**
 * The material as heights on a grid: what a cutter of three axes leaves when it has gone along a path.
 *
 * Every cut lowers the cells under its disc. Going back means beginning anew: heights only fall.
 */

import { cut, type Piece } from "./piece";

export interface StockShape {
  /** Corner with the least X and Y, mm from the origin of the preview. */
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly depth: number;
  /** Height of the surface. */
  readonly top: number;
  /** Radius of the cutter, mm. */
  readonly radius: number;
}

/** Area in which a stock is cut, seen from above: mm from the origin of the preview. */
export interface Bared {
  /** Square millimetres. */
  readonly area: number;
  readonly min: readonly [number, number];
  readonly max: readonly [number, number];
}

/** Cells along the longer side. */
const cells = 320;

export class Stock {
  readonly shape: StockShape;
  readonly cell: number;
  readonly columns: number;
  readonly rows: number;
  readonly heights: Float32Array<ArrayBuffer>;
  #pieces: readonly Piece[] = [];
  #piece = 0;
  #segment = 0;
  #until = 0;

  constructor(shape: StockShape) {
    this.shape = shape;
    this.cell = Math.max(shape.width, shape.depth) / cells;
    this.columns = Math.max(2, Math.ceil(shape.width / this.cell) + 1);
    this.rows = Math.max(2, Math.ceil(shape.depth / this.cell) + 1);
    this.heights = new Float32Array(this.columns * this.rows).fill(shape.top);
  }

  /**
   * Sets the cut that is to be made: the path up to a planned time. Starts anew for another path or an
   * earlier time.
   */
  aim(pieces: readonly Piece[], seconds: number): void {
    if (pieces !== this.#pieces || seconds < this.#until) {
      this.heights.fill(this.shape.top);
      this.#piece = 0;
      this.#segment = 0;
    }
    this.#pieces = pieces;
    this.#until = seconds;
  }

  /** Goes on for at most so many segments. Tells whether all is done. */
  cutOn(segments: number): boolean {
    for (let left = segments; left > 0; left -= 1) {
      const piece = this.#pieces[this.#piece];
      if (!piece) return true;
      const over = piece.over[this.#segment];
      if (over === undefined) {
        this.#piece += 1;
        this.#segment = 0;
        continue;
      }
      if (over > this.#until) return true;
      if (piece.kinds[this.#segment] === cut) this.#sweep(piece, this.#segment);
      this.#segment += 1;
    }
    return false;
  }

  /** Area that is cut so far, seen from above; nothing before the first cut. */
  bared(): Bared | null {
    const { x, y, top } = this.shape;
    let [cellsCut, left, right, low, high] = [0, this.columns, -1, this.rows, -1];
    this.heights.forEach((height, n) => {
      if (height >= top) return;
      const [column, row] = [n % this.columns, Math.floor(n / this.columns)];
      [left, right] = [Math.min(left, column), Math.max(right, column)];
      [low, high] = [Math.min(low, row), Math.max(high, row)];
      cellsCut += 1;
    });
    if (cellsCut === 0) return null;
    const { cell } = this;
    return {
      area: cellsCut * cell * cell,
      min: [x + left * cell, y + low * cell],
      max: [x + right * cell, y + high * cell],
    };
  }

  /** Lowers what lies under the cutter along a segment, disc by disc. */
  #sweep({ vertices }: Piece, n: number): void {
    const at = (k: number) => vertices[3 * n + k] ?? 0;
    const way = [at(3) - at(0), at(4) - at(1), at(5) - at(2)] as const;
    const steps = Math.max(1, Math.ceil(Math.hypot(way[0], way[1]) / this.cell));
    for (let k = 0; k <= steps; k += 1) {
      const share = k / steps;
      this.#lower(at(0) + way[0] * share, at(1) + way[1] * share, at(2) + way[2] * share);
    }
  }

  #lower(x: number, y: number, z: number): void {
    if (z >= this.shape.top) return;
    const reach = this.shape.radius / this.cell;
    const column = (x - this.shape.x) / this.cell;
    const row = (y - this.shape.y) / this.cell;
    const lastRow = Math.min(this.rows - 1, Math.floor(row + reach));
    for (let r = Math.max(0, Math.ceil(row - reach)); r <= lastRow; r += 1) {
      const half = Math.sqrt(Math.max(0, reach * reach - (r - row) ** 2));
      const last = Math.min(this.columns - 1, Math.floor(column + half));
      for (let c = Math.max(0, Math.ceil(column - half)); c <= last; c += 1) {
        const cell = r * this.columns + c;
        if ((this.heights[cell] ?? z) > z) this.heights[cell] = z;
      }
    }
  }
}
