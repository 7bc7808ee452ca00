/**
 * A piece of a tool path as the server sends it (`crates/wire/src/preview.rs` has the layout).
 *
 * The arrays are views of the bytes that came: nothing is copied.
 */

export interface Piece {
  readonly segments: number;
  /** X Y Z of `segments + 1` vertices, mm from the origin of the preview. */
  readonly vertices: Float32Array;
  /** End of each segment, seconds of planned time. */
  readonly over: Float32Array;
  /** The line of the part file that makes it. */
  readonly lines: Uint32Array;
  /** The move it belongs to. */
  readonly moves: Uint32Array;
  readonly kinds: Uint8Array;
}

export const jog = 0;
export const cut = 1;
export const gap = 2;

const headBytes = 8;

/** Reads a piece; throws when the bytes are not one. */
export function readPiece(bytes: ArrayBuffer): Piece {
  const segments = new DataView(bytes).getUint32(0, true);
  const expected = headBytes + 12 * (segments + 1) + 13 * segments;
  if (bytes.byteLength < expected) throw new RangeError("a piece of the tool path is cut off");
  let at = headBytes;
  const take = (length: number) => {
    const from = at;
    at += length;
    return from;
  };
  return {
    segments,
    vertices: new Float32Array(bytes, take(12 * (segments + 1)), 3 * (segments + 1)),
    over: new Float32Array(bytes, take(4 * segments), segments),
    lines: new Uint32Array(bytes, take(4 * segments), segments),
    moves: new Uint32Array(bytes, take(4 * segments), segments),
    kinds: new Uint8Array(bytes, take(segments), segments),
  };
}
