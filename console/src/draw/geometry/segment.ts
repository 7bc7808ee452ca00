/**
 * A line or an arc between two vertices.
 *
 * The bulge is the tangent of a quarter of the arc's angle, positive counter-clockwise; 0 is a line.
 * Formulas: b = tan(θ/4), radius = chord (1 + b²) / (4 |b|), centre on the left normal of the chord.
 */

import {
  type Box,
  between,
  boxOf,
  cross,
  distance,
  dot,
  left,
  minus,
  type Place,
  place,
  plus,
  times,
} from "./vec";

export interface Segment {
  readonly from: Place;
  readonly to: Place;
  readonly bulge: number;
}

export interface Arc {
  readonly centre: Place;
  readonly radius: number;
  /** Angle of the start, radians. */
  readonly start: number;
  /** Angle turned, radians, positive counter-clockwise. */
  readonly sweep: number;
}

/** Below this bulge a segment is a line to the eye and to a thousandth of a millimetre. */
const straight = 1e-9;

export const isLine = (segment: Segment): boolean => Math.abs(segment.bulge) < straight;

/** The arc of a segment that is none of the lines. */
export function arcOf({ from, to, bulge }: Segment): Arc {
  const chord = minus(to, from);
  const middle = between(from, to, 0.5);
  const centre = plus(middle, times(left(chord), (1 - bulge * bulge) / (4 * bulge)));
  const away = minus(from, centre);
  return {
    centre,
    radius: distance(from, centre),
    start: Math.atan2(away.y, away.x),
    sweep: 4 * Math.atan(bulge),
  };
}

const onCircle = ({ centre, radius }: Arc, angle: number): Place =>
  place(centre.x + radius * Math.cos(angle), centre.y + radius * Math.sin(angle));

/** The place a share of the way along, 0 … 1. */
export function placeAt(segment: Segment, share: number): Place {
  if (isLine(segment)) return between(segment.from, segment.to, share);
  const arc = arcOf(segment);
  return onCircle(arc, arc.start + arc.sweep * share);
}

/** The share of the way at which an arc passes an angle; beyond 1 when it does not. */
function shareOfAngle({ start, sweep }: Arc, angle: number): number {
  const turn = sweep > 0 ? angle - start : start - angle;
  const whole = 2 * Math.PI;
  return (((turn % whole) + whole) % whole) / Math.abs(sweep);
}

/** The share of the way whose place is nearest, kept between two shares. */
export function nearestShare(segment: Segment, to: Place, low = 0, high = 1): number {
  const share = isLine(segment) ? alongLine(segment, to) : alongArc(segment, to);
  if (share >= low && share <= high) return share;
  const [a, b] = [placeAt(segment, low), placeAt(segment, high)];
  return distance(a, to) <= distance(b, to) ? low : high;
}

function alongLine({ from, to: end }: Segment, to: Place): number {
  const way = minus(end, from);
  const long = dot(way, way);
  return long === 0 ? 0 : dot(minus(to, from), way) / long;
}

function alongArc(segment: Segment, to: Place): number {
  const arc = arcOf(segment);
  const away = minus(to, arc.centre);
  return shareOfAngle(arc, Math.atan2(away.y, away.x));
}

export const nearestPlace = (segment: Segment, to: Place): Place =>
  placeAt(segment, nearestShare(segment, to));

export const distanceTo = (segment: Segment, to: Place): number =>
  distance(nearestPlace(segment, to), to);

/** The direction of travel at the start, radians. */
export function startAngle(segment: Segment): number {
  const chord = minus(segment.to, segment.from);
  return Math.atan2(chord.y, chord.x) - 2 * Math.atan(segment.bulge);
}

/** The smallest box, the bulge of arcs included. */
export function segmentBox(segment: Segment): Box {
  const ends = boxOf(segment.from, segment.to);
  if (isLine(segment)) return ends;
  const arc = arcOf(segment);
  const quarters = [0, 1, 2, 3].map((quarter) => (quarter * Math.PI) / 2);
  const reached = quarters.filter((angle) => shareOfAngle(arc, angle) <= 1);
  const places = [segment.from, segment.to, ...reached.map((angle) => onCircle(arc, angle))];
  return {
    min: place(Math.min(...places.map((p) => p.x)), Math.min(...places.map((p) => p.y))),
    max: place(Math.max(...places.map((p) => p.x)), Math.max(...places.map((p) => p.y))),
  };
}

/** The bulge of the arc from `from` to `to` whose apex lies where a place is projected on the chord's normal. */
export function bulgeThrough(from: Place, to: Place, apex: Place): number {
  const chord = minus(to, from);
  const long = dot(chord, chord);
  return long === 0 ? 0 : (-2 * cross(chord, minus(apex, from))) / long;
}

/** Tells whether a share lies on the segment. */
const onIt = (share: number): boolean => share > -1e-9 && share < 1 + 1e-9;

/** Places at which two segments meet. */
export function meetings(a: Segment, b: Segment): Place[] {
  const [lineA, lineB] = [isLine(a), isLine(b)];
  if (lineA && lineB) return lineMeetsLine(a, b);
  if (lineA) return lineMeetsArc(a, b);
  if (lineB) return lineMeetsArc(b, a);
  return arcMeetsArc(a, b);
}

function lineMeetsLine(a: Segment, b: Segment): Place[] {
  const [u, v] = [minus(a.to, a.from), minus(b.to, b.from)];
  const slant = cross(u, v);
  if (Math.abs(slant) < 1e-12) return [];
  const between = minus(b.from, a.from);
  const [onA, onB] = [cross(between, v) / slant, cross(between, u) / slant];
  return onIt(onA) && onIt(onB) ? [plus(a.from, times(u, onA))] : [];
}

function lineMeetsArc(line: Segment, curve: Segment): Place[] {
  const arc = arcOf(curve);
  const way = minus(line.to, line.from);
  const away = minus(line.from, arc.centre);
  const [a, b] = [dot(way, way), 2 * dot(way, away)];
  const c = dot(away, away) - arc.radius * arc.radius;
  const root = b * b - 4 * a * c;
  if (a === 0 || root < 0) return [];
  const shares = [-1, 1].map((sign) => (-b + sign * Math.sqrt(root)) / (2 * a));
  return shares
    .filter(onIt)
    .map((share) => plus(line.from, times(way, share)))
    .filter((meeting) => isOnArc(arc, meeting));
}

function arcMeetsArc(a: Segment, b: Segment): Place[] {
  const [one, two] = [arcOf(a), arcOf(b)];
  const apart = minus(two.centre, one.centre);
  const far = Math.hypot(apart.x, apart.y);
  if (far === 0) return [];
  const along = (far * far + one.radius ** 2 - two.radius ** 2) / (2 * far);
  const high = one.radius ** 2 - along * along;
  if (high < 0) return [];
  const foot = plus(one.centre, times(apart, along / far));
  const side = times(left(apart), Math.sqrt(high) / far);
  return [plus(foot, side), minus(foot, side)].filter(
    (meeting) => isOnArc(one, meeting) && isOnArc(two, meeting),
  );
}

function isOnArc(arc: Arc, at: Place): boolean {
  const away = minus(at, arc.centre);
  const share = shareOfAngle(arc, Math.atan2(away.y, away.x));
  const whole = (2 * Math.PI) / Math.abs(arc.sweep);
  return onIt(share) || onIt(share - whole);
}
