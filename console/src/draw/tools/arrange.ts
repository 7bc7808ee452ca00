/** Tools that put shapes elsewhere or make more of them. */

import { t } from "../../words/words";
import { distance, minus } from "../geometry/vec";
import { after, grown, mirrored, shifted, spun } from "./matrix";
import {
  type Answer,
  amountOf,
  noGhost,
  num,
  numbersOf,
  placeOf,
  select,
  type Tool,
  xy,
} from "./tool";
import { wrapped } from "./turn";

const shapes = { ask: "shapes", prompt: t("Shapes") } as const;
const basePlace = { ask: "place", prompt: t("Base place") } as const;
const target = { ask: "place", prompt: t("Where it goes") } as const;

/** Turn by the arrow keys, as an operation about the place where the shapes went. */
const turning = (turned: number, about: string): string =>
  wrapped(turned) === 0 ? "" : `; rotate ${num(wrapped(turned))} about ${about}`;

/** Move and copy: the shapes follow the mouse, turned by the arrow keys. */
const carrying: NonNullable<Tool["ghost"]> = ([picked, base], at, turned) => {
  if (!base) return noGhost;
  const from = placeOf(base);
  return {
    kind: "moved",
    numbers: numbersOf(picked),
    by: after(spun(at, turned), shifted(from, at)),
  };
};

const carry = (id: "move" | "copy", title: string, doc: string): Tool => ({
  id,
  title,
  doc,
  menu: "arrange",
  asks: [shapes, basePlace, target],
  turns: true,
  clauses: ([picked, from, to], turned) => {
    const [a, b] = [xy(placeOf(from)), xy(placeOf(to))];
    return `${select(numbersOf(picked))}; ${id} from ${a} to ${b}${turning(turned, b)}`;
  },
  ghost: carrying,
});

const move = carry("move", t("Move"), t("From a base place to another; arrow keys turn."));
const copy = carry("copy", t("Copy"), t("Copies, from a base place to another; arrow keys turn."));

const rotate: Tool = {
  id: "rotate",
  title: t("Rotate"),
  doc: t("Counter-clockwise about a place, by the mouse or a typed angle."),
  menu: "arrange",
  asks: [
    shapes,
    { ask: "place", prompt: t("Centre") },
    {
      ask: "number",
      prompt: t("Angle"),
      kind: "angle",
      usual: 90,
      from: (at, [, centre]) => angleTo(placeOf(centre), at),
    },
  ],
  clauses: ([picked, centre, angle]) =>
    `${select(numbersOf(picked))}; rotate ${num(amountOf(angle))} about ${xy(placeOf(centre))}`,
  ghost: ([picked, centre], at) => {
    if (!centre) return noGhost;
    const about = placeOf(centre);
    return { kind: "moved", numbers: numbersOf(picked), by: spun(about, angleTo(about, at)) };
  },
};

type At = Parameters<typeof minus>[0];

function angleTo(centre: At, at: At): number {
  const way = minus(at, centre);
  return (Math.atan2(way.y, way.x) * 180) / Math.PI;
}

const scale: Tool = {
  id: "scale",
  title: t("Scale"),
  doc: t("By a factor about a place; 25.4 makes millimetres of inches."),
  menu: "arrange",
  asks: [
    shapes,
    { ask: "place", prompt: t("Centre") },
    {
      ask: "number",
      prompt: t("Factor"),
      kind: "plain",
      usual: 2,
      accepts: (value) => (value > 0 ? undefined : t("has to be greater than 0")),
    },
  ],
  clauses: ([picked, centre, factor]) =>
    `${select(numbersOf(picked))}; scale ${num(amountOf(factor))} about ${xy(placeOf(centre))}`,
  ghost: ([picked, centre, factor]) => {
    if (!centre || !factor) return noGhost;
    return {
      kind: "moved",
      numbers: numbersOf(picked),
      by: grown(placeOf(centre), amountOf(factor)),
    };
  },
};

const basisFrom = { ask: "place", prompt: t("Start of the base line") } as const;
const basisTo = { ask: "place", prompt: t("Its end") } as const;

/** The base line that was given: its ends, and the words that name them. */
function basis(from: Answer | undefined, to: Answer | undefined) {
  const [a, b] = [placeOf(from), placeOf(to)];
  return { a, b, words: `from ${xy(a)} ${xy(b)}` };
}

const rotateTo: Tool = {
  id: "rotate-to",
  title: t("Rotate to"),
  doc: t("Turns the shapes so that a line of theirs gets an angle, by the mouse or typed."),
  menu: "arrange",
  asks: [
    shapes,
    basisFrom,
    basisTo,
    {
      ask: "number",
      prompt: t("Angle it gets"),
      kind: "angle",
      usual: 90,
      from: (at, [, from]) => angleTo(placeOf(from), at),
    },
  ],
  clauses: ([picked, from, to, angle]) =>
    `${select(numbersOf(picked))}; rotate to ${num(amountOf(angle))} ${basis(from, to).words}`,
  ghost: ([picked, from, to], at) => {
    if (!from || !to) return noGhost;
    const { a, b } = basis(from, to);
    const by = spun(a, angleTo(a, at) - angleTo(a, b));
    return { kind: "moved", numbers: numbersOf(picked), by };
  },
};

const scaleTo: Tool = {
  id: "scale-to",
  title: t("Scale to"),
  doc: t("Makes the shapes larger so that a line of theirs gets a length, by the mouse or typed."),
  menu: "arrange",
  asks: [
    shapes,
    basisFrom,
    basisTo,
    {
      ask: "number",
      prompt: t("Length it gets"),
      kind: "length",
      usual: 100,
      accepts: (value) => (value > 0 ? undefined : t("has to be greater than 0")),
      from: (at, [, from]) => distance(placeOf(from), at),
    },
  ],
  clauses: ([picked, from, to, length]) =>
    `${select(numbersOf(picked))}; scale to ${num(amountOf(length))} ${basis(from, to).words}`,
  ghost: ([picked, from, to], at) => {
    if (!from || !to) return noGhost;
    const { a, b } = basis(from, to);
    if (distance(a, b) === 0) return noGhost;
    const by = grown(a, distance(a, at) / distance(a, b));
    return { kind: "moved", numbers: numbersOf(picked), by };
  },
};

const mirror: Tool = {
  id: "mirror",
  title: t("Mirror"),
  doc: t("At the line through two places."),
  menu: "arrange",
  asks: [
    shapes,
    { ask: "place", prompt: t("A place of the mirror line") },
    { ask: "place", prompt: t("Another place of it") },
  ],
  clauses: ([picked, a, b]) =>
    `${select(numbersOf(picked))}; mirror ${xy(placeOf(a))} ${xy(placeOf(b))}`,
  ghost: ([picked, a], at) => {
    if (!a || distance(placeOf(a), at) === 0) return noGhost;
    return { kind: "moved", numbers: numbersOf(picked), by: mirrored(placeOf(a), at) };
  },
};

const whole = (value: number) =>
  Number.isInteger(value) && value >= 1 ? undefined : t("has to be a whole number from 1");

const arrayInRows: Tool = {
  id: "array-rect",
  title: t("Array in rows"),
  doc: t("Rows and columns of the shapes, with gaps between them."),
  menu: "arrange",
  asks: [
    shapes,
    { ask: "number", prompt: t("Rows"), kind: "plain", usual: 2, accepts: whole },
    { ask: "number", prompt: t("Columns"), kind: "plain", usual: 2, accepts: whole },
    { ask: "number", prompt: t("Gap between columns"), kind: "length", usual: 10 },
    { ask: "number", prompt: t("Gap between rows"), kind: "length", usual: 10 },
  ],
  clauses: ([picked, rows, columns, across, up]) =>
    `${select(numbersOf(picked))}; array rect ${amountOf(rows)}x${amountOf(columns)} ` +
    `spacing ${num(amountOf(across))},${num(amountOf(up))}`,
};

const arrayRound: Tool = {
  id: "array-round",
  title: t("Array round a centre"),
  doc: t("So many of the shapes on a circle, the first one counted."),
  menu: "arrange",
  asks: [
    shapes,
    { ask: "number", prompt: t("How many"), kind: "plain", usual: 6, accepts: whole },
    { ask: "place", prompt: t("Centre") },
  ],
  clauses: ([picked, count, centre]) =>
    `${select(numbersOf(picked))}; array round ${amountOf(count)} about ${xy(placeOf(centre))}`,
};

const clip: Tool = {
  id: "clip",
  title: t("To clipboard"),
  doc: t("Puts copies of shapes onto the clipboard."),
  menu: "arrange",
  asks: [shapes],
  clauses: ([picked]) => `${select(numbersOf(picked))}; clip`,
};

const paste: Tool = {
  id: "paste",
  title: t("Paste"),
  doc: t("The clipboard's shapes, their lower left at a place; arrow keys turn."),
  menu: "arrange",
  asks: [{ ask: "place", prompt: t("Lower left") }],
  turns: true,
  clauses: ([to], turned) => `paste ${xy(placeOf(to))}${turning(turned, xy(placeOf(to)))}`,
};

const pasteAbsolute: Tool = {
  id: "paste-absolute",
  title: t("Paste absolute"),
  doc: t("The clipboard's shapes as far from a place as they were from their own origin."),
  menu: "arrange",
  asks: [{ ask: "place", prompt: t("Their origin") }],
  clauses: ([to]) => `paste absolute ${xy(placeOf(to))}`,
};

const origin: Tool = {
  id: "origin",
  title: t("Origin"),
  doc: t("Makes a place the origin of the drawing."),
  menu: "arrange",
  asks: [{ ask: "place", prompt: t("The new origin") }],
  clauses: ([at]) => `origin ${xy(placeOf(at))}`,
};

export const arrangeTools: readonly Tool[] = [
  move,
  copy,
  rotate,
  rotateTo,
  scale,
  scaleTo,
  mirror,
  arrayInRows,
  arrayRound,
  clip,
  paste,
  pasteAbsolute,
  origin,
];
