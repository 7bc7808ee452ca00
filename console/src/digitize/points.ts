/** Points that are being digitized, as sheets show them, and what the hand console has them look at. */

import { type Shape, shapeOf } from "../draw/geometry/shape";
import { type Box, isEmpty, joined, type Place, place } from "../draw/geometry/vec";
import { fitted, type Size, type Window, zoomedTo } from "../draw/window";
import type { Digitized, Look } from "../wire/messages";

/** Digitized point as a sheet draws it. */
export interface DigitizedItem {
  readonly kind: "digitized";
  /** The lines and arcs through the points. */
  readonly path: Shape;
  readonly points: readonly DigitizedMark[];
}

export interface DigitizedMark {
  readonly at: Place;
  readonly arc: boolean;
  /** True for the point that is inserted, changed or deleted next. */
  readonly current: boolean;
}

export function digitizedItem({ points, bulges, current }: Digitized): DigitizedItem {
  const vertices = points.flatMap(({ at: [x, y] }, n) => [x, y, bulges[n] ?? 0]);
  const plain = { number: 0, group: "black", closed: false, pause: false, z: null };
  return {
    kind: "digitized",
    path: shapeOf({ ...plain, points: vertices }),
    points: points.map(({ at: [x, y], arc }, n) => ({
      at: place(x, y),
      arc,
      current: n + 1 === current,
    })),
  };
}

export interface InSight {
  readonly window: Window;
  readonly size: Size;
  /** Bounds of all shapes. */
  readonly data: Box;
  readonly points: DigitizedItem | null;
  /** The machine's bounds, from where the shapes have their origin; nothing without any. */
  readonly machine: Box | null;
  /** So many times larger than that is what is shown. */
  readonly expansion: number;
}

/** Box that a sheet shows after a look (digitizing functions 30 to 33). */
export function lookedAt(
  look: Look,
  { window, size, data, points, machine, expansion }: InSight,
): Window {
  const drawn = points ? joined(data, points.path.box) : data;
  const to = (box: Box) => (isEmpty(box) ? window : fitted(box, size, expansion));
  switch (look) {
    case "digitized":
      return points ? to(points.path.box) : window;
    case "data":
      return to(drawn);
    case "machine":
      return to(machine ? joined(machine, drawn) : drawn);
    case "out":
      return zoomedTo(window, window.middle, 0.5);
  }
}
