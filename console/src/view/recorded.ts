/** Points that are being digitized, in the picture of the tool path, and what the hand console has it look at. */

import { paintMark } from "../digitize/paint";
import { digitizedItem } from "../digitize/points";
import { isLine, placeAt, type Segment } from "../draw/geometry/segment";
import { inkOf } from "../draw/ink";
import type { Digitized, Look } from "../wire/messages";
import { type Bounds, type Camera, project, type Size, type Vec3 } from "./camera";
import { around } from "./typed";

/** The points and the way through them, in the frame of the picture. */
export interface Recorded {
  readonly points: readonly {
    readonly at: Vec3;
    readonly arc: boolean;
    readonly current: boolean;
  }[];
  /** Places close enough to each other to be joined by lines. */
  readonly way: readonly Vec3[];
}

/** An arc is drawn as so many lines. */
const chords = 32;

/** Places what is digitized in the picture: from its origin, mm in the machine's frame. */
export function recordedIn(digitized: Digitized, origin: Vec3): Recorded {
  const [x0, y0] = digitized.origin;
  const from = (x: number, y: number, z: number): Vec3 => [
    x + x0 - origin[0],
    y + y0 - origin[1],
    z - origin[2],
  ];
  const heights = digitized.points.map(({ at }) => at[2]);
  const item = digitizedItem(digitized);
  const points = item.points.map(({ at, arc, current }, n) => ({
    at: from(at.x, at.y, heights[n] ?? 0),
    arc,
    current,
  }));
  const way = item.path.segments.flatMap((segment, n) => {
    const [low, high] = [heights[n] ?? 0, heights[n + 1] ?? 0];
    return shares(segment).map((share) => {
      const { x, y } = placeAt(segment, share);
      return from(x, y, low + share * (high - low));
    });
  });
  return { points, way };
}

const shares = (segment: Segment): number[] =>
  isLine(segment) ? [0, 1] : Array.from({ length: chords + 1 }, (_, n) => n / chords);

/** Bounds of the points and the way; nothing without points. */
export function recordedBounds({ points, way }: Recorded): Bounds | undefined {
  const places = [...points.map(({ at }) => at), ...way];
  return places.reduce<Bounds | undefined>(
    (all, at) => around(all, { min: at, max: at }),
    undefined,
  );
}

export interface InPicture {
  /** Bounds of the tool path and of what is typed. */
  readonly data: Bounds | undefined;
  readonly recorded: Bounds | undefined;
  /** The machine's bounds; nothing without any. */
  readonly machine: Bounds | undefined;
}

/** The box to be in the picture after a look (digitizing functions 30 to 32); nothing where it stays as it is. */
export function sightOf(look: Look, { data, recorded, machine }: InPicture): Bounds | undefined {
  const drawn = around(data, recorded);
  switch (look) {
    case "digitized":
      return recorded;
    case "data":
      return drawn;
    case "machine":
      return around(machine, drawn);
    case "out":
      return undefined;
  }
}

export function paintRecorded(
  pen: CanvasRenderingContext2D,
  size: Size,
  camera: Camera,
  { points, way }: Recorded,
): void {
  const ink = inkOf(pen.canvas);
  pen.setLineDash([]);
  pen.strokeStyle = ink("--draw-digitized");
  pen.lineWidth = 2.5;
  pen.beginPath();
  for (const place of way) {
    const { x, y } = project(camera, place, size);
    pen.lineTo(x, y);
  }
  pen.stroke();
  for (const mark of points) paintMark(pen, project(camera, mark.at, size), mark, ink);
}
