/** Finds places on a tool path: by planned time, by move. */

import type { Vec3 } from "./camera";
import type { Piece } from "./piece";

/** The first of ascending numbers that is at least `wanted`; the length when none is. */
export function firstAtLeast(numbers: ArrayLike<number>, wanted: number): number {
  let [low, high] = [0, numbers.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((numbers[middle] ?? 0) < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}

export interface Place {
  readonly at: Vec3;
  readonly line: number;
}

/** A vertex of a piece. */
export const vertexOf = ({ vertices }: Piece, n: number): Vec3 => [
  vertices[3 * n] ?? 0,
  vertices[3 * n + 1] ?? 0,
  vertices[3 * n + 2] ?? 0,
];

/** The share of a segment that is made at a time. */
function shareAt(piece: Piece, n: number, seconds: number): number {
  const until = piece.over[n] ?? 0;
  const since = n > 0 ? (piece.over[n - 1] ?? 0) : 0;
  return until > since ? Math.min(1, Math.max(0, (seconds - since) / (until - since))) : 1;
}

/** Place of the tool at a moment of planned time, and the line that moves it. */
export function placeAt(pieces: readonly Piece[], seconds: number): Place | undefined {
  const last = pieces.at(-1);
  const piece = pieces.find(({ over }) => (over.at(-1) ?? 0) >= seconds) ?? last;
  if (!piece || piece.segments === 0) return undefined;
  const n = Math.min(firstAtLeast(piece.over, seconds), piece.segments - 1);
  const [from, to] = [vertexOf(piece, n), vertexOf(piece, n + 1)];
  const share = shareAt(piece, n, seconds);
  const between = (axis: 0 | 1 | 2) => from[axis] + (to[axis] - from[axis]) * share;
  return { at: [between(0), between(1), between(2)], line: piece.lines[n] ?? 0 };
}

/** The planned time at which so many moves are made. */
export function timeOfMoves(pieces: readonly Piece[], made: number): number {
  const piece = pieces.find(({ moves }) => (moves.at(-1) ?? 0) >= made) ?? pieces.at(-1);
  if (!piece || made <= 0) return 0;
  const n = firstAtLeast(piece.moves, made);
  if (n > 0) return piece.over[n - 1] ?? 0;
  const before = pieces[pieces.indexOf(piece) - 1];
  return before?.over.at(-1) ?? 0;
}
