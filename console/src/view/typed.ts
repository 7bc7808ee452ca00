/** The path of what is typed as it grows: fetched from where it is known already. */

import { createStore, type Store } from "../app/store";
import { getBytes } from "../link/http";
import type { TypedPath } from "../wire/messages";
import type { Bounds, Vec3 } from "./camera";
import { gap, type Piece, readPiece } from "./piece";
import { vertexOf } from "./place";

export interface Typed {
  readonly key: number;
  readonly segments: number;
  /** Vertices are mm from the machine's zero. */
  readonly pieces: readonly Piece[];
}

export const nothingTyped: Typed = { key: 0, segments: 0, pieces: [] };

/** The path with a piece more. */
export function grown(path: Typed, key: number, piece: Piece): Typed {
  const before = path.key === key ? path : { ...nothingTyped, key };
  return {
    key,
    segments: before.segments + piece.segments,
    pieces: [...before.pieces, piece],
  };
}

/** Bounds of its moves; nothing while none is drawn. */
export function typedBounds({ pieces }: Typed): Bounds | undefined {
  const moves = pieces.flatMap((piece) =>
    Array.from(piece.kinds).flatMap((kind, n) => (kind === gap ? [] : [segment(piece, n)])),
  );
  return moves.reduce<Bounds | undefined>((all, one) => around(all, one), undefined);
}

/** Bounds of a segment. */
function segment(piece: Piece, n: number): Bounds {
  const [from, to] = [vertexOf(piece, n), vertexOf(piece, n + 1)];
  return { min: lesser(from, to, Math.min), max: lesser(from, to, Math.max) };
}

/** Both in one; what is nothing does not count. */
export function around(a: Bounds | undefined, b: Bounds | undefined): Bounds | undefined {
  if (!a || !b) return a ?? b;
  return { min: lesser(a.min, b.min, Math.min), max: lesser(a.max, b.max, Math.max) };
}

const lesser = (a: Vec3, b: Vec3, of: (a: number, b: number) => number): Vec3 => [
  of(a[0], b[0]),
  of(a[1], b[1]),
  of(a[2], b[2]),
];

export interface Following {
  readonly path: Store<Typed>;
  /** The server has drawn so much. */
  told(path: TypedPath): void;
}

type Fetches = (address: string) => Promise<ArrayBuffer>;

/** Follows the path, one request after the other. */
export function followTyped(fetches: Fetches = getBytes): Following {
  const path = createStore<Typed>(nothingTyped);
  let wanted: TypedPath = nothingTyped;
  let busy = false;
  const known = () => (path.get().key === wanted.key ? path.get().segments : 0);
  const catchUp = async () => {
    while (known() < wanted.segments) {
      const { key } = wanted;
      const bytes = await fetches(`/api/typed/${key}/${known()}`);
      // Begun anew meanwhile: what is told now is fetched next.
      if (key !== wanted.key) continue;
      if (bytes.byteLength === 0) return;
      path.update((now) => grown(now, key, readPiece(bytes)));
    }
  };
  return {
    path,
    told(next) {
      wanted = next;
      if (next.segments === 0 && path.get().segments > 0) path.set({ ...nothingTyped, ...next });
      if (busy) return;
      busy = true;
      catchUp()
        // The link is gone: the next that is told is fetched again.
        .catch(() => undefined)
        .finally(() => {
          busy = false;
        });
    },
  };
}
