import { describe, expect, it } from "vitest";
import { readPiece } from "./piece";
import { firstAtLeast, placeAt, timeOfMoves } from "./place";

/** A piece as the server writes it: along X, a segment of 10 mm each. */
function bytesOf(over: number[], moves: number[], fromX = 0): ArrayBuffer {
  const n = over.length;
  const bytes = new ArrayBuffer(8 + 12 * (n + 1) + 13 * n);
  new DataView(bytes).setUint32(0, n, true);
  const vertices = Array.from({ length: n + 1 }, (_, k) => [fromX + 10 * k, 0, -1]).flat();
  new Float32Array(bytes, 8, vertices.length).set(vertices);
  let at = 8 + 12 * (n + 1);
  new Float32Array(bytes, at, n).set(over);
  at += 4 * n;
  new Uint32Array(bytes, at, n).set(moves.map((move) => move + 100));
  at += 4 * n;
  new Uint32Array(bytes, at, n).set(moves);
  return bytes;
}

const pieces = [readPiece(bytesOf([1, 2], [0, 1])), readPiece(bytesOf([4, 5], [1, 2], 20))];

describe("a tool path in pieces", () => {
  it("is read without copying", () => {
    const bytes = bytesOf([1, 2], [0, 1]);
    expect(readPiece(bytes).vertices.buffer).toBe(bytes);
    expect(() => readPiece(bytes.slice(0, 40))).toThrow("cut off");
  });

  it("finds the first number that is large enough", () => {
    for (const [wanted, found] of [
      [0, 0],
      [1, 0],
      [2, 1],
      [9, 4],
    ] as const)
      expect(firstAtLeast([1, 3, 3, 5], wanted)).toBe(found);
  });

  it("tells where the tool is at a time", () => {
    for (const [seconds, x, line] of [
      [0, 0, 100],
      [0.5, 5, 100],
      [1.5, 15, 101],
      [4.5, 35, 102],
      [99, 40, 102],
    ] as const)
      expect(placeAt(pieces, seconds)).toEqual({ at: [x, 0, -1], line });
    expect(placeAt([], 1)).toBeUndefined();
  });

  it("tells when moves are made", () => {
    expect(timeOfMoves(pieces, 0)).toBe(0);
    expect(timeOfMoves(pieces, 1)).toBe(1);
    expect(timeOfMoves(pieces, 2)).toBe(4);
    expect(timeOfMoves(pieces, 3)).toBe(5);
    expect(timeOfMoves([], 3)).toBe(0);
  });
});
