/** Snaps: a key before a pick makes it exact. One pick long; Q turns it off again. */

import { t } from "../words/words";
import {
  arcOf,
  isLine,
  meetings,
  nearestPlace,
  nearestShare,
  placeAt,
  type Segment,
} from "./geometry/segment";
import { distance, type Place, place } from "./geometry/vec";
import type { Picking, Piece } from "./pick";

export type SnapKey = "v" | "c" | "m" | "i" | "n" | "g";

export const snapNames: Record<SnapKey, string> = {
  v: t("vertex"),
  c: t("centre"),
  m: t("midpoint"),
  i: t("intersection"),
  n: t("nearest"),
  g: t("square to the base point"),
};

export const isSnapKey = (key: string): key is SnapKey => key in snapNames;

/** The keys that mean something at a pick: G only where there is a base point. */
export const keysAt = (base: Place | null): string => (base ? "VCMINGQ" : "VCMINQ");

/** The place a pick means; nothing when there is nothing to snap to within the radius. */
export function snapped(
  key: SnapKey | null,
  at: Place,
  picking: Picking,
  radius: number,
  base: Place | null,
): Place | null {
  if (key === null) return at;
  if (key === "g") return base && squareTo(base, at);
  return nearestOf(finders[key](picking.near(at, radius), at, radius), at);
}

type Finder = (pieces: readonly Piece[], at: Place, radius: number) => readonly Place[];

/** Keeps what a finder finds within the radius. */
const within =
  (finder: Finder): Finder =>
  (pieces, at, radius) =>
    finder(pieces, at, radius).filter((found) => distance(found, at) <= radius);

/** Centres and midpoints may lie outside of the radius: their arc or segment is within. */
const finders: Record<Exclude<SnapKey, "g">, Finder> = {
  v: within((pieces) => pieces.flatMap(endsOf)),
  c: centre,
  m: midpoint,
  i: within((pieces) => crossings(pieces)),
  n: within((pieces, at) => pieces.flatMap((piece) => nearestOn(piece, at))),
};

/** On the row or the column of the base point, whichever is farther. */
export function squareTo(base: Place, at: Place): Place {
  const across = Math.abs(at.x - base.x) > Math.abs(at.y - base.y);
  return across ? place(at.x, base.y) : place(base.x, at.y);
}

const endsOf = ({ shape, segment }: Piece): readonly Place[] =>
  segment ? [segment.from, segment.to] : shape.vertices;

const nearestOn = ({ shape, segment }: Piece, at: Place): readonly Place[] =>
  segment ? [nearestPlace(segment, at)] : shape.vertices;

const isArc = (segment: Segment | null): segment is Segment => segment !== null && !isLine(segment);

/** The centre of the nearest arc. */
function centre(pieces: readonly Piece[], at: Place): Place[] {
  const arcs = pieces.map(({ segment }) => segment).filter(isArc);
  const nearest = leastBy(arcs, (arc) => distance(nearestPlace(arc, at), at));
  return nearest ? [arcOf(nearest).centre] : [];
}

/** The middle of the nearest segment whose middle three fifths come within the radius. */
function midpoint(pieces: readonly Piece[], at: Place, radius: number): Place[] {
  const away = (s: Segment) => distance(placeAt(s, nearestShare(s, at, 0.2, 0.8)), at);
  const segments = pieces.flatMap(({ segment }) => segment ?? []);
  const nearest = leastBy(
    segments.filter((s) => away(s) <= radius),
    away,
  );
  return nearest ? [placeAt(nearest, 0.5)] : [];
}

/** Places at which segments cross; neighbours of one shape meet in their vertex, which is no crossing. */
function crossings(pieces: readonly Piece[]): Place[] {
  return pieces.flatMap((a, n) =>
    pieces.slice(n + 1).flatMap((b) => {
      if (!a.segment || !b.segment) return [];
      const met = meetings(a.segment, b.segment);
      return a.shape === b.shape ? met.filter((at) => !isEndOfBoth(at, a, b)) : met;
    }),
  );
}

const isEndOfBoth = (at: Place, ...pieces: readonly Piece[]): boolean =>
  pieces.every((piece) => endsOf(piece).some((end) => distance(end, at) < 1e-9));

const nearestOf = (places: readonly Place[], at: Place): Place | null =>
  leastBy(places, (candidate) => distance(candidate, at));

function leastBy<T>(items: readonly T[], measure: (item: T) => number): T | null {
  let least: T | null = null;
  let lowest = Number.POSITIVE_INFINITY;
  for (const item of items) {
    const value = measure(item);
    if (value < lowest) [least, lowest] = [item, value];
  }
  return least;
}
