/** Tools that change shapes where they are. */

import { t } from "../../words/words";
import { bulgeThrough, distanceTo, type Segment } from "../geometry/segment";
import type { Shape } from "../geometry/shape";
import type { Place } from "../geometry/vec";
import {
  type Answer,
  amountOf,
  marksOf,
  noGhost,
  num,
  numbersOf,
  placeOf,
  select,
  shapeAt,
  type Tool,
  xy,
} from "./tool";

const shapes = { ask: "shapes", prompt: t("Shapes") } as const;
const notNegative = (value: number) => (value >= 0 ? undefined : t("cannot be negative"));

const erase: Tool = {
  id: "erase",
  title: t("Erase"),
  doc: t("Removes shapes."),
  menu: "edit",
  asks: [shapes],
  clauses: ([picked]) => `${select(numbersOf(picked))}; erase`,
};

const fillet: Tool = {
  id: "fillet",
  title: t("Fillet"),
  doc: t("Rounds the corner nearest to a place."),
  menu: "edit",
  asks: [
    { ask: "number", prompt: t("Radius"), kind: "length", usual: 5, accepts: notNegative },
    { ask: "shape", prompt: t("Corner") },
  ],
  repeats: true,
  clauses: ([radius, corner]) => {
    const { number, at } = shapeAt(corner);
    return `${select([number])}; fillet ${num(amountOf(radius))} at ${xy(at)}`;
  },
};

const chamfer: Tool = {
  id: "chamfer",
  title: t("Chamfer"),
  doc: t("Cuts the corner nearest to a place off."),
  menu: "edit",
  asks: [
    { ask: "number", prompt: t("Length"), kind: "length", usual: 5, accepts: notNegative },
    { ask: "shape", prompt: t("Corner") },
  ],
  repeats: true,
  clauses: ([length, corner]) => {
    const { number, at } = shapeAt(corner);
    return `${select([number])}; chamfer ${num(amountOf(length))} at ${xy(at)}`;
  },
};

const offset: Tool = {
  id: "offset",
  title: t("Offset"),
  doc: t("Paths beside the shapes, to the right of travel; a negative distance to the left."),
  menu: "edit",
  asks: [
    shapes,
    { ask: "number", prompt: t("Distance, right of travel"), kind: "length", usual: 3 },
  ],
  clauses: ([picked, by]) => `${select(numbersOf(picked))}; offset ${num(amountOf(by))} keep`,
};

const join: Tool = {
  id: "join",
  title: t("Join"),
  doc: t("Makes one of open shapes whose ends are that near."),
  menu: "edit",
  asks: [
    shapes,
    { ask: "number", prompt: t("Largest gap"), kind: "length", usual: 0.1, accepts: notNegative },
  ],
  clauses: ([picked, gap]) => `${select(numbersOf(picked))}; join ${num(amountOf(gap))}`,
};

const breakTool: Tool = {
  id: "break",
  title: t("Break"),
  doc: t("Opens a closed shape at a place; makes two of an open one."),
  menu: "edit",
  asks: [{ ask: "shape", prompt: t("Place of the break") }],
  repeats: true,
  clauses: ([where]) => {
    const { number, at } = shapeAt(where);
    return `break ${number} ${xy(at)}`;
  },
};

const trim: Tool = {
  id: "trim",
  title: t("Trim"),
  doc: t("Takes out the part between the shapes picked first."),
  menu: "edit",
  asks: [
    { ask: "shapes", prompt: t("Cutting shapes") },
    { ask: "shape", prompt: t("Part to take out") },
  ],
  clauses: ([edges, part]) => `${select(numbersOf(edges))}; trim ${xy(shapeAt(part).at)}`,
};

const stretch: Tool = {
  id: "stretch",
  title: t("Stretch"),
  doc: t("Moves vertices that are picked one by one, or by a window."),
  menu: "edit",
  asks: [
    shapes,
    { ask: "vertices", prompt: t("Vertices, or a window round them") },
    { ask: "place", prompt: t("Base place") },
    { ask: "place", prompt: t("Where it goes") },
  ],
  clauses: ([picked, marks, base, to]) => {
    const [a, b] = [placeOf(base), placeOf(to)];
    const by = { x: b.x - a.x, y: b.y - a.y };
    const places = marksOf(marks).map(({ at }) => xy(at));
    return `${select(numbersOf(picked))}; stretch at ${places.join(" ")} by ${xy(by)}`;
  },
};

const vertex: Tool = {
  id: "vertex",
  title: t("Move vertex"),
  doc: t("Moves the vertex nearest to a place."),
  menu: "edit",
  asks: [
    { ask: "shape", prompt: t("Vertex") },
    { ask: "place", prompt: t("Where it goes") },
  ],
  clauses: ([which, to]) => {
    const { number, at } = shapeAt(which);
    return `vertex ${number} ${xy(at)} ${xy(placeOf(to))}`;
  },
};

const deleteVertex: Tool = {
  id: "delete-vertex",
  title: t("Delete vertex"),
  doc: t("Takes vertices out that are picked one by one, or by a window."),
  menu: "edit",
  asks: [{ ask: "vertices", prompt: t("Vertices, or a window round them") }],
  repeats: true,
  clauses: ([picked]) => {
    const marks = marksOf(picked);
    const numbers = [...new Set(marks.map(({ number }) => number))];
    const places = (number: number) =>
      marks.filter((mark) => mark.number === number).map(({ at }) => xy(at));
    return numbers
      .map((number) => `delete-vertices ${number} ${places(number).join(" ")}`)
      .join("; ");
  },
};

const bulge: Tool = {
  id: "bulge",
  title: t("Bulge"),
  doc: t("Bends a segment with the mouse, or by a typed bulge; 0 is a line."),
  menu: "edit",
  asks: [
    { ask: "shape", prompt: t("Segment") },
    {
      ask: "number",
      prompt: t("Bulge"),
      kind: "plain",
      usual: 0,
      from: (at, [which], all) => bulgeAt(all, which, at),
    },
  ],
  clauses: ([which, value]) => {
    const { number, at } = shapeAt(which);
    return `bulge ${number} ${xy(at)} ${num(amountOf(value))}`;
  },
  ghost: ([which], at, _, all) => {
    const segment = which && segmentAt(all, shapeAt(which));
    const bulge = bulgeAt(all, which, at);
    return segment ? { kind: "segments", segments: [{ ...segment, bulge }] } : noGhost;
  },
};

/** The segment of a shape that is nearest to a place. */
function segmentAt(
  all: readonly Shape[],
  { number, at }: { readonly number: number; readonly at: Place },
): Segment | undefined {
  const segments = all.find((shape) => shape.number === number)?.segments ?? [];
  return [...segments].sort((a, b) => distanceTo(a, at) - distanceTo(b, at))[0];
}

/** The bulge that bends a segment to the mouse. */
function bulgeAt(all: readonly Shape[], which: Answer | undefined, at: Place): number {
  const segment = which && segmentAt(all, shapeAt(which));
  return segment ? bulgeThrough(segment.from, segment.to, at) : 0;
}

export const editTools: readonly Tool[] = [
  erase,
  fillet,
  chamfer,
  offset,
  join,
  breakTool,
  trim,
  stretch,
  vertex,
  deleteVertex,
  bulge,
];
