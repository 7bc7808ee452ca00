/**
 * Numbers with a unit as types, and the only doors between them.
 *
 * Inside, and on the wire, lengths are millimetres, angles degrees, times seconds. A person reads and types lengths in
 * the unit of the page. The compiler refuses one for the other, a speed for a length, a speed a minute for one a second.
 * Arithmetic gives plain numbers, as in hot loops of geometry; [`mm`] and its like give them their unit again. What one
 * unit of the page is stays closed: nothing but the functions here multiplies with it or divides by it.
 */

declare const unit: unique symbol;

/** A number that is counted in a unit. */
type Quantity<Unit extends string> = number & { readonly [unit]: Unit };

export type Mm = Quantity<"mm">;
export type MmPerS = Quantity<"mm/s">;
export type MmPerMin = Quantity<"mm/min">;
export type Degrees = Quantity<"deg">;
export type DegreesPerS = Quantity<"deg/s">;
/** A length of time. */
export type Seconds = Quantity<"s">;
/** A moment: seconds since 1970, UTC. */
export type UnixSeconds = Quantity<"s since 1970">;

/** A length in the unit of the page, which is read and typed there. */
export type Shown = Quantity<"page">;
export type ShownPerS = Quantity<"page/s">;
export type ShownPerMin = Quantity<"page/min">;
/** A place or a way of an axis in the unit in which it is read: that of the page, or degrees. */
export type ShownOnAxis = Quantity<"axis">;

/** A place or a way of an axis, which may turn. */
export type AxisValue = Mm | Degrees;
/** X Y Z A B C. */
export type AxisPlace = [Mm, Mm, Mm, AxisValue, AxisValue, AxisValue];
/** A place to which only some axes go. */
export type AxisGoal = OrStays<AxisPlace>;
type OrStays<Place> = { [Axis in keyof Place]: Place[Axis] | null };
type AxisSpeed = MmPerS | DegreesPerS;
/** X and Y together, then Z, A, B, C. */
export type AxisSpeeds = [MmPerS, MmPerS, AxisSpeed, AxisSpeed, AxisSpeed];

/** Internal units (mm or degrees) in one that is shown: a number that only the functions of this file read. */
export interface UnitSize {
  readonly [unit]: "size";
}

/** The unit of lengths on the page, as [`Units`](../wire/messages) has it. */
export interface LengthUnit {
  /** `in` or `mm`. */
  readonly linear: string;
  readonly mm: UnitSize;
}

/** A plain number: one that has a unit already is refused. */
type Plain<N extends number> = N extends { readonly [unit]: string } ? never : N;

export const mm = <N extends number>(length: Plain<N>): Mm => length as number as Mm;
export const mmPerS = <N extends number>(speed: Plain<N>): MmPerS => speed as number as MmPerS;
export const degrees = <N extends number>(angle: Plain<N>): Degrees => angle as number as Degrees;
export const seconds = <N extends number>(time: Plain<N>): Seconds => time as number as Seconds;
/** A number that stands in a field of lengths. */
export const shown = <N extends number>(length: Plain<N>): Shown => length as number as Shown;
/** A number that stands in a field of speeds a minute. */
export const shownPerMin = <N extends number>(speed: Plain<N>): ShownPerMin =>
  speed as number as ShownPerMin;
/** A number that stands in a field of an axis. */
export const shownOnAxis = <N extends number>(value: Plain<N>): ShownOnAxis =>
  value as number as ShownOnAxis;

/** The way from one to the other, in their unit. */
export const difference = <Q extends Quantity<string>>(to: Q, from: Q): Q => (to - from) as Q;

/** To the nearest of so many parts of one. */
export const rounded = <Q extends number>(value: Q, parts: number): Q =>
  (Math.round(value * parts) / parts) as Q;

/** A place to which only some axes go, from a value or nothing for each of the six. */
export const goal = (place: readonly (AxisValue | null)[]): AxisGoal =>
  place as readonly (number | null)[] as AxisGoal;

const unitSize = (internal: number): UnitSize => internal as unknown as UnitSize;
const numberIn = (size: UnitSize): number => size as unknown as number;

/** The unit before the server told one. */
export const millimetres: LengthUnit = { linear: "mm", mm: unitSize(1) };
export const inches: LengthUnit = { linear: "in", mm: unitSize(25.4) };

/** True where the page shows millimetres. */
export const isMetric = ({ mm }: LengthUnit): boolean => numberIn(mm) === 1;

/** A length as the page shows it. */
export const inUnit = (length: Mm, { mm }: LengthUnit): Shown => shown(length / numberIn(mm));

/** The length that the page shows so. */
export const ofUnit = (length: Shown, page: LengthUnit): Mm => mm(length * numberIn(page.mm));

/** A speed along a path as the page shows it by the second. */
export const perSecondInUnit = (speed: MmPerS, { mm }: LengthUnit): ShownPerS =>
  (speed / numberIn(mm)) as ShownPerS;

/** A speed a minute as the page shows it. */
export const perMinuteInUnit = (speed: MmPerMin, { mm }: LengthUnit): ShownPerMin =>
  shownPerMin(speed / numberIn(mm));

/** The speed that the page shows so. */
export const perMinuteOfUnit = (speed: ShownPerMin, { mm }: LengthUnit): MmPerMin =>
  (speed * numberIn(mm)) as MmPerMin;

export const perMinute = (speed: MmPerS): MmPerMin => (speed * 60) as MmPerMin;

/** The unit of an axis, as [`AxisUnits`](../wire/messages) has it. */
interface AxisUnit {
  readonly scale: UnitSize;
}

/** A place or a way of an axis as it is shown. */
export const inAxisUnit = (value: AxisValue, { scale }: AxisUnit): ShownOnAxis =>
  shownOnAxis(value / numberIn(scale));

/** The place or way of an axis that is shown so. */
export const ofAxisUnit = (value: ShownOnAxis, { scale }: AxisUnit): AxisValue =>
  mm(value * numberIn(scale));

/** A unit by its name, for values that come as text with it: `mm`, `mm/s` and `mm/s²` become those of the page. */
export function namedUnit(name: string, page: LengthUnit): { name: string; size: number } {
  return /^mm(\/(s[²³]?|min))?$/.test(name) && !isMetric(page)
    ? { name: name.replace("mm", page.linear), size: numberIn(page.mm) }
    : { name, size: 1 };
}

/** Lengths of the units that a person may write behind a number. */
const written = new Map([
  ["mm", mm(1)],
  ["cm", mm(10)],
  ["m", mm(1000)],
  ["in", mm(25.4)],
  ['"', mm(25.4)],
  ["ft", mm(304.8)],
  ["'", mm(304.8)],
]);

/** One of a unit that a person wrote behind a number; nothing where the word is none. */
export const oneOf = (word: string): Mm | undefined => written.get(word.toLowerCase());
