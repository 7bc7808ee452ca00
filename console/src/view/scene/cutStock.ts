/** The material of a path and the surface that shows it. */

import { type Bared, Stock, type StockShape } from "../stock";
import type { CoarsePath } from "./orders";
import { StockMesh } from "./stockMesh";

/** Segments that are cut in one frame. */
const swift = 1500;

/** The material reaches beyond the cuts by this share of the cutter. */
const margin = 1.5;

export class CutStock {
  readonly mesh: StockMesh;
  readonly #stock: Stock;
  readonly #path: CoarsePath;

  constructor(path: CoarsePath) {
    this.#path = path;
    this.#stock = new Stock(shapeOf(path));
    this.mesh = new StockMesh(this.#stock);
  }

  /** Cuts what is made at a planned time. Tells whether that is all. */
  carve(seconds: number): boolean {
    this.#stock.aim(this.#path.pieces, seconds);
    const all = this.#stock.cutOn(swift);
    this.mesh.show();
    return all;
  }

  /** Area that is cut so far. */
  bared(): Bared | null {
    return this.#stock.bared();
  }

  dispose(): void {
    this.mesh.dispose();
  }
}

function shapeOf({ info }: CoarsePath): StockShape {
  const [low, high] = info.bounds ?? [info.zero, info.zero];
  const beyond = Math.max(info.cutter, 1) * margin;
  return {
    x: low[0] - info.origin[0] - beyond,
    y: low[1] - info.origin[1] - beyond,
    width: high[0] - low[0] + 2 * beyond,
    depth: high[1] - low[1] + 2 * beyond,
    top: info.zero[2] - info.origin[2],
    radius: Math.max(info.cutter / 2, 0.1),
  };
}
