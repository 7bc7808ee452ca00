/** Share of the current move that is made. */

import type { Vec3 } from "./camera";
import { cut, type Piece } from "./piece";
import { firstAtLeast, vertexOf } from "./place";

/** A stretch of the path: made already, or still to be. */
export interface Stretch {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly made: boolean;
}

/** The tool lies on a segment when it is so near, mm: what the picture leaves out of curves is less. */
const onPath = 0.5;

/**
 * The segment that is being cut, in the part behind the tool and the one before it. Nothing while it
 * jogs, and where the tool is not on the path that is looked at.
 */
export function stretches(pieces: readonly Piece[], seconds: number, tool: Vec3): Stretch[] {
  const piece = pieces.find(({ over }) => (over.at(-1) ?? 0) > seconds);
  if (!piece) return [];
  const n = firstAtLeast(piece.over, seconds + 1e-9);
  // Several segments may belong to one move: the tool is on one of them.
  for (let k = n; k < piece.segments && piece.moves[k] === piece.moves[n]; k += 1) {
    const [from, to] = [vertexOf(piece, k), vertexOf(piece, k + 1)];
    if (piece.kinds[k] !== cut || distanceTo(from, to, tool) > onPath) continue;
    return [
      { from: vertexOf(piece, n), to: tool, made: true },
      { from: tool, to, made: false },
    ];
  }
  return [];
}

function distanceTo(from: Vec3, to: Vec3, at: Vec3): number {
  const way = minus(to, from);
  const long = Math.hypot(...way);
  const away = minus(at, from);
  const sum = way[0] * away[0] + way[1] * away[1] + way[2] * away[2];
  const share = long > 0 ? Math.min(1, Math.max(0, sum / (long * long))) : 0;
  return Math.hypot(away[0] - way[0] * share, away[1] - way[1] * share, away[2] - way[2] * share);
}

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
