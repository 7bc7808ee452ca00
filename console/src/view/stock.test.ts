import { describe, expect, it } from "vitest";
import type { Piece } from "./piece";
import { Stock } from "./stock";

/** A cut along X at a depth, ten seconds long, after a jog of one second. */
const path = (depth: number): Piece => ({
  segments: 2,
  vertices: new Float32Array([0, 0, 5, 10, 50, depth, 90, 50, depth]),
  over: new Float32Array([1, 11]),
  lines: new Uint32Array([1, 2]),
  moves: new Uint32Array([0, 1]),
  kinds: new Uint8Array([0, 1]),
});

const shape = { x: 0, y: 0, width: 100, depth: 100, top: 0, radius: 5 };
const heightAt = (stock: Stock, x: number, y: number) =>
  stock.heights[Math.round(y / stock.cell) * stock.columns + Math.round(x / stock.cell)];

function cutUntil(stock: Stock, pieces: readonly Piece[], seconds: number) {
  stock.aim(pieces, seconds);
  while (!stock.cutOn(1));
}

describe("the stock", () => {
  it("loses what the cutter goes over, and nothing else", () => {
    const stock = new Stock(shape);
    cutUntil(stock, [path(-3)], 11);
    expect(heightAt(stock, 50, 50)).toBe(-3);
    expect(heightAt(stock, 50, 54)).toBe(-3);
    expect(heightAt(stock, 50, 56)).toBe(0);
    expect(heightAt(stock, 5, 5)).toBe(0);
  });

  it("tells where it is cut, and how much of it", () => {
    const stock = new Stock(shape);
    stock.aim([path(-3)], 0);
    expect(stock.bared()).toBe(null);
    cutUntil(stock, [path(-3)], 11);
    const { area = 0, min = [], max = [] } = stock.bared() ?? {};
    // A slot of 80 mm with round ends of a cutter of 10 mm.
    expect(area / (80 * 10 + Math.PI * 25)).toBeCloseTo(1, 1);
    expect([min[0], max[0]].map((x) => Math.round(x ?? 0))).toEqual([5, 95]);
    expect([min[1], max[1]].map((y) => Math.round(y ?? 0))).toEqual([45, 55]);
  });

  it("is whole again before the cut", () => {
    const stock = new Stock(shape);
    const pieces = [path(-3)];
    cutUntil(stock, pieces, 11);
    cutUntil(stock, pieces, 0.5);
    expect(heightAt(stock, 50, 50)).toBe(0);
  });

  it("is never raised by a shallower cut", () => {
    const stock = new Stock(shape);
    cutUntil(stock, [path(-3), path(-1)], 99);
    expect(heightAt(stock, 50, 50)).toBe(-3);
  });

  it("is not cut by a path above it", () => {
    const stock = new Stock(shape);
    cutUntil(stock, [path(2)], 99);
    expect(stock.heights.every((height) => height === 0)).toBe(true);
  });
});
