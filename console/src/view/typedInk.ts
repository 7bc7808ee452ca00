/** Draws what is typed over the tool path. */

import { type Camera, project, type Size, type Vec3 } from "./camera";
import { gap, jog, type Piece } from "./piece";
import { vertexOf } from "./place";
import type { Palette } from "./scene/palette";
import type { TypedView } from "./useTyped";

/** Marks of the typed moves, in the frame of the picture. */
export interface TypedMarks extends TypedView {
  /** The origin of the picture's places: mm, machine frame. */
  readonly origin: Vec3;
  /** Jogs are drawn. */
  readonly jogs: boolean;
}

export function paintTyped(
  pen: CanvasRenderingContext2D,
  size: Size,
  camera: Camera,
  { path, live, origin, jogs }: TypedMarks,
  palette: Palette,
): void {
  const at = (place: Vec3) =>
    project(camera, [place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]], size);
  const lines = { jogs: new Path2D(), cuts: new Path2D() };
  for (const piece of path.pieces)
    for (let n = 0; n < piece.segments; n += 1) {
      if (piece.kinds[n] !== gap)
        line(
          piece.kinds[n] === jog ? lines.jogs : lines.cuts,
          [end(piece, n), end(piece, n + 1)],
          at,
        );
    }
  const last = path.pieces.at(-1);
  if (live.length > 0) line(lines.cuts, last ? [end(last, last.segments), ...live] : live, at);
  pen.lineWidth = 1.5;
  pen.strokeStyle = palette.jog;
  if (jogs) pen.stroke(lines.jogs);
  pen.lineWidth = 2;
  pen.strokeStyle = palette.cut;
  pen.stroke(lines.cuts);
}

const end = (piece: Piece, n: number): Vec3 => vertexOf(piece, n);

function line(
  into: Path2D,
  places: readonly Vec3[],
  at: (place: Vec3) => { x: number; y: number },
): void {
  places.map(at).forEach(({ x, y }, n) => {
    if (n === 0) into.moveTo(x, y);
    else into.lineTo(x, y);
  });
}
