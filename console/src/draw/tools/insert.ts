/** Tools that draw something new. */

import { t } from "../../words/words";
import type { Segment } from "../geometry/segment";
import { distance, type Place, place } from "../geometry/vec";
import { amountOf, num, pathOf, placeOf, type Tool, xy } from "./tool";

const positive = (value: number) => (value > 0 ? undefined : t("has to be greater than 0"));

const circle: Tool = {
  id: "circle",
  title: t("Circle"),
  doc: t("Centre, then radius with the mouse or typed."),
  menu: "insert",
  asks: [
    { ask: "place", prompt: t("Centre") },
    {
      ask: "number",
      prompt: t("Radius"),
      kind: "length",
      usual: 10,
      accepts: positive,
      from: (at, [centre]) => distance(placeOf(centre), at),
    },
  ],
  clauses: ([centre, radius]) => `circle ${xy(placeOf(centre))} ${num(amountOf(radius))}`,
  ghost: ([centre], at) => {
    if (!centre) return { kind: "none" };
    const middle = placeOf(centre);
    return { kind: "segments", segments: ring(middle, distance(middle, at)) };
  },
};

const ring = ({ x, y }: Place, radius: number): Segment[] => [
  { from: place(x + radius, y), to: place(x - radius, y), bulge: 1 },
  { from: place(x - radius, y), to: place(x + radius, y), bulge: 1 },
];

const rectangle: Tool = {
  id: "rectangle",
  title: t("Rectangle"),
  doc: t("Two opposite corners; @width,height types the second."),
  menu: "insert",
  asks: [
    { ask: "place", prompt: t("First corner") },
    { ask: "place", prompt: t("Opposite corner (or @width,height)") },
  ],
  clauses: ([a, b]) => `rect ${xy(placeOf(a))} ${xy(placeOf(b))}`,
  ghost: ([a], at) =>
    a ? { kind: "segments", segments: frame(placeOf(a), at) } : { kind: "none" },
};

/** The four sides of a rectangle. */
export function frame(a: Place, b: Place): Segment[] {
  const corners = [a, place(b.x, a.y), b, place(a.x, b.y)];
  return corners.map((from, n) => ({ from, to: corners[(n + 1) % 4] ?? a, bulge: 0 }));
}

const point: Tool = {
  id: "point",
  title: t("Point"),
  doc: t("A place to drill."),
  menu: "insert",
  asks: [{ ask: "place", prompt: t("Place") }],
  repeats: true,
  clauses: ([at]) => `point ${xy(placeOf(at))}`,
};

const drawn = (arcs: boolean): Tool["clauses"] => {
  return ([path]) => {
    const { vertices, closed } = pathOf(path);
    const words = vertices.map(({ at, bulge }) =>
      arcs && bulge !== 0 ? `${xy(at)},${num(bulge)}` : xy(at),
    );
    return `line ${words.join(" ")}${closed ? " close" : ""}`;
  };
};

const line: Tool = {
  id: "line",
  title: t("Line"),
  doc: t("Lines from place to place; V on the start closes, the right button ends."),
  menu: "insert",
  asks: [{ ask: "path", prompt: t("Next place"), arcs: false }],
  clauses: drawn(false),
};

const polyarc: Tool = {
  id: "polyarc",
  title: t("Arc"),
  doc: t("Each segment's end, then its bulge with the mouse."),
  menu: "insert",
  asks: [{ ask: "path", prompt: t("Next place"), arcs: true }],
  clauses: drawn(true),
};

export const insertTools: readonly Tool[] = [line, polyarc, rectangle, circle, point];
