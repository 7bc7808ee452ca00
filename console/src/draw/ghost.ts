/** Ghost of a change, drawn at the mouse while a tool is at work. */

import { type Around, type DeskState, isFar, pickPlace, shapesUnder } from "./desk";
import { bulgeThrough, type Segment } from "./geometry/segment";
import type { Shape } from "./geometry/shape";
import type { Place } from "./geometry/vec";
import type { Overlay } from "./paint/overlay";
import { shifted } from "./tools/matrix";
import { asked, baseOf, type Running } from "./tools/running";
import { type Ghost, noGhost } from "./tools/tool";

export function overlayOf(state: DeskState, around: Around): Overlay {
  const { running, pointer, drag, window } = state;
  const { shapes } = around.picking;
  const at = pointer && pickPlace(state, pointer, around);
  const ghost = running && at ? ghostOf(running, at, shapes) : carriedBy(state);
  const picks = picksOf(running, around);
  return {
    hovered: hoveredOf(state, around),
    picked: byNumber(shapes, picks.numbers),
    marks: running?.marks.map(({ at }) => at) ?? [],
    numbered: picks.numbered,
    ghost,
    ghostShapes: ghost.kind === "moved" ? byNumber(shapes, ghost.numbers) : [],
    path: running && at ? pathTo(running, at) : [],
    region: drag?.kind === "region" && away(drag.from, drag.to, window.mmPerPixel) ? drag : null,
    snap: running?.snap && at ? at : null,
    pointer,
    radius: running?.snap ? around.pickRadius : null,
    square: running?.snap === "g" ? baseOf(running) : null,
  };
}

/** Shapes that are dragged follow the mouse. */
function carriedBy({ drag, window }: DeskState): Ghost {
  if (drag?.kind !== "shapes" || !isFar(drag, window)) return noGhost;
  return { kind: "moved", numbers: drag.numbers, by: shifted(drag.from, drag.to) };
}

/** Shapes that are picked: by the tool at work, else to be sequenced later. */
function picksOf(running: Running | null, { picked }: Around) {
  if (!running) return { numbers: picked, numbered: true };
  const ask = asked(running);
  return { numbers: running.picked, numbered: ask?.ask === "shapes" && ask.numbered === true };
}

const away = (a: Place, b: Place, mmPerPixel: number): boolean =>
  Math.max(Math.abs(a.x - b.x), Math.abs(a.y - b.y)) > 4 * mmPerPixel;

const ghostOf = ({ tool, answers, turned }: Running, at: Place, shapes: readonly Shape[]) =>
  tool.ghost?.(answers, at, turned, shapes) ?? noGhost;

const byNumber = (shapes: readonly Shape[], numbers: readonly number[]): Shape[] =>
  numbers.flatMap((number) => shapes.find((shape) => shape.number === number) ?? []);

/** Shapes that a click would pick. */
function hoveredOf(state: DeskState, around: Around): Shape[] {
  const { running, pointer, drag } = state;
  const ask = running && asked(running)?.ask;
  const picks = !running || ask === "shapes" || ask === "shape";
  if (!picks || !pointer || drag) return [];
  return shapesUnder(state, pointer, around);
}

/** The path drawn so far, and on to the mouse. */
function pathTo({ vertices, bending }: Running, at: Place): Segment[] {
  const last = vertices.at(-1);
  if (!last) return [];
  const made = vertices.slice(0, -1).map((vertex, n) => ({
    from: vertex.at,
    to: vertices[n + 1]?.at ?? vertex.at,
    bulge: vertex.bulge,
  }));
  const next = bending
    ? { from: last.at, to: bending, bulge: bulgeThrough(last.at, bending, at) }
    : { from: last.at, to: at, bulge: 0 };
  return [...made, next];
}

/** Place from which a typed place counts. */
export const entryBase = (running: Running | null): Place | null => running && baseOf(running);
