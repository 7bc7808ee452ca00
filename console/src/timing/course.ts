/** The lines of a chart as paths of pixels, and what they are at a moment. */

import type { TimingLine } from "../wire/messages";
import { t } from "../words/words";
import { pixelOf, type Span } from "./span";

export type Point = readonly [at: number, value: number];

/** Pixels of a row in which a line is drawn. */
export interface Box {
  readonly width: number;
  readonly top: number;
  readonly bottom: number;
}

/** Name of a line on the chart. */
export const nameOf = ({ kind, name }: Pick<TimingLine, "kind" | "name">): string =>
  kind === "axis" ? name.toUpperCase() : name;

/** Least and greatest. */
export type Range = readonly [low: number, high: number];

export const isBit = ({ kind }: Pick<TimingLine, "kind">): boolean =>
  kind === "output" || kind === "input";

/** Number of points at a moment or before. */
function before(points: readonly Point[], at: number): number {
  let [low, high] = [0, points.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((points[middle]?.[0] ?? 0) <= at) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Value of a line at a moment. */
export function valueAt(line: Pick<TimingLine, "kind" | "points">, at: number): number {
  const { points } = line;
  const next = before(points, at);
  const [a, b] = [points[next - 1], points[next]];
  if (line.kind !== "axis") return a?.[1] ?? 0;
  if (!a) return b?.[1] ?? 0;
  if (!b || b[0] <= a[0]) return a[1];
  return a[1] + ((b[1] - a[1]) * (at - a[0])) / (b[0] - a[0]);
}

/**
 * Time by which an edge may lie before a span and still belong to it, seconds: one at zero is at its very
 * beginning.
 */
const slack = 1e-9;

/** The edges of a bit that are shown. */
export const edgesIn = ({ points }: Pick<TimingLine, "points">, span: Span): readonly Point[] =>
  points.slice(before(points, span.from - slack), before(points, span.to));

/** Not by Math.min(...): a line has more values than a call takes. */
export function spread(values: readonly number[]): Range {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return [low, high];
}

/** The points that are shown, and one beyond each end of the span. */
function shown(points: readonly Point[], span: Span): readonly Point[] {
  return points.slice(Math.max(before(points, span.from) - 1, 0), before(points, span.to) + 1);
}

/** Of the points on one pixel only the first, the least, the greatest and the last. */
function thinned(points: readonly (readonly [x: number, y: number])[]) {
  const out: (readonly [number, number])[] = [];
  for (let n = 0; n < points.length; ) {
    const start = n;
    const column = Math.floor(points[n]?.[0] ?? 0);
    while (n < points.length && Math.floor(points[n]?.[0] ?? 0) === column) n += 1;
    const here = points.slice(start, n);
    if (here.length <= 4) out.push(...here);
    else {
      const ys = here.map(([, y]) => y);
      const x = here[0]?.[0] ?? 0;
      out.push([x, ys[0] ?? 0], [x, Math.min(...ys)], [x, Math.max(...ys)], [x, ys.at(-1) ?? 0]);
    }
  }
  return out;
}

const pathOf = (points: readonly (readonly [number, number])[]): string =>
  points.map(([x, y], n) => `${n === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");

/** Least and greatest value of a line; what changes in steps is 0 before the first. */
export function rangeOf({ kind, points }: Pick<TimingLine, "kind" | "points">): Range {
  const starts = kind === "axis" ? points[0]?.[1] : 0;
  return spread([starts ?? 0, ...points.map(([, value]) => value)]);
}

/** Gives the height at which a value is drawn: the least at the bottom of its row, the greatest at the top. */
export const heightOf = ([low, high]: Range, { top, bottom }: Box) => {
  const tall = Math.max(high - low, 1e-9);
  return (value: number) => bottom - ((value - low) / tall) * (bottom - top);
};

/** Path of a line that changes in steps: a value holds until the next. */
function stepPath(line: Steps, height: (value: number) => number, span: Span, box: Box): string {
  const { points } = line;
  const begins = points[before(points, span.from - slack) - 1]?.[1] ?? 0;
  const corners: [number, number][] = [[0, height(begins)]];
  for (const [at, value] of edgesIn({ points }, span)) {
    const x = pixelOf(span, at, box.width);
    corners.push([x, corners.at(-1)?.[1] ?? 0], [x, height(value)]);
  }
  corners.push([box.width, corners.at(-1)?.[1] ?? 0]);
  return pathOf(thinned(corners));
}

type Steps = Pick<TimingLine, "points">;

/** The line as a path of an SVG; a value fills its row from its least to its greatest. */
export function coursePath(
  line: Pick<TimingLine, "kind" | "points">,
  range: Range,
  span: Span,
  box: Box,
): string {
  if (isBit(line)) return stepPath(line, (on) => (on > 0 ? box.top : box.bottom), span, box);
  const height = heightOf(range, box);
  if (line.kind === "value") return stepPath(line, height, span, box);
  const corners = shown(line.points, span).map(([at, value]): [number, number] => [
    pixelOf(span, at, box.width),
    height(value),
  ]);
  // Before its first point and behind its last it stays.
  const [first, last] = [corners[0], corners.at(-1)];
  if (!first || !last) return "";
  const ends: [number, number][] = [[Math.max(last[0], box.width), last[1]]];
  return pathOf(thinned([[Math.min(first[0], 0), first[1]], ...corners, ...ends]));
}

/** A moment beside its edge; before it where there is no room behind. */
export interface Label {
  readonly at: number;
  readonly x: number;
  readonly before: boolean;
}

/** The moments of edges that have that many pixels of room. */
export function labelled(line: TimingLine, span: Span, width: number, room: number) {
  const labels: Label[] = [];
  let free = 0;
  for (const [at] of edgesIn(line, span)) {
    const x = pixelOf(span, at, width);
    const before = x + room > width;
    const [from, to] = before ? [x - room, x] : [x, x + room];
    if (from < free) continue;
    labels.push({ at, x, before });
    free = to;
  }
  return labels;
}

/** Edges that are told in words; whoever wants more looks at a shorter stretch. */
const mostTold = 12;

/** A bit in words: what it is where the span begins, and its edges there. */
export function bitWords(line: TimingLine, span: Span): string {
  const edges = edgesIn(line, span);
  const on = (line.points[before(line.points, span.from - slack) - 1]?.[1] ?? 0) > 0;
  if (edges.length === 0) return t("{0} is {1} all the time", line.name, onOff(on));
  const begins = span.from > 0 ? [t("{0} at {1} s", onOff(on), span.from.toFixed(3))] : [];
  const told = edges.slice(0, mostTold).map(edgeWords);
  const more = edges.length > mostTold ? t(" and {0} more", edges.length - mostTold) : "";
  return `${line.name}: ${[...begins, ...told].join(", ")}${more}`;
}

const onOff = (on: boolean): string => (on ? t("on") : t("off"));

const edgeWords = ([at, on]: Point): string =>
  at === 0 ? t("{0} from the beginning", onOff(on > 0)) : `${onOff(on > 0)} ${at.toFixed(3)} s`;
