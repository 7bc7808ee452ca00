/**
 * Reads a place or a number that a person types.
 *
 * Places: `x,y`, `@dx,dy` from the last place, `len<angle` from the last place. Numbers are
 * expressions; each term has a unit of its own or the user's: `3/4in+2mm`, `(10+5)/2`.
 */

import { evaluate } from "../app/expression";
import {
  type Degrees,
  degrees,
  type LengthUnit,
  type Mm,
  type MmPerMin,
  millimetres,
  ofUnit,
  perMinuteOfUnit,
  rounded,
  shown,
  shownPerMin,
} from "../units/quantity";
import { t } from "../words/words";
import { type Place, place } from "./geometry/vec";

/** A reading, or words that say what is wrong. */
export type Read<T> = { readonly value: T } | { readonly wrong: string };

export const isWrong = <T>(read: Read<T>): read is { readonly wrong: string } => "wrong" in read;

/** Parts of a millimetre that nobody can type on purpose are left out. */
const finest = 1e9;

function readAs<N extends number>(
  text: string,
  unit: LengthUnit,
  as: (value: number) => N,
): Read<N> {
  const value = evaluate(text, unit);
  if (value === undefined) return { wrong: t("“{0}” is no number.", text.trim()) };
  return { value: as(value) };
}

/** A length, in the unit of the page where it says none. */
export const readLength = (text: string, unit: LengthUnit): Read<Mm> =>
  // Units of units: 2mm in inches is 2 mm again, not 1.9999999999999998.
  readAs(text, unit, (value) => rounded(ofUnit(shown(value), unit), finest));

/** A speed a minute, as a length. */
export const readSpeed = (text: string, unit: LengthUnit): Read<MmPerMin> =>
  readAs(text, unit, (value) => rounded(perMinuteOfUnit(shownPerMin(value), unit), finest));

/** A number without a unit: a factor, a count, a bulge. */
export const readNumber = (text: string): Read<number> =>
  readAs(text, millimetres, (value) => rounded(value, finest));

/** An angle. */
export const readAngle = (text: string): Read<Degrees> =>
  readAs(text, millimetres, (value) => rounded(degrees(value), finest));

const placeWords = t("A place is x,y or @dx,dy or length<angle.");

/** A place. `base` is the last place, from which `@` and `<` count; else from the origin. */
export function readPlace(text: string, unit: LengthUnit, base: Place | null): Read<Place> {
  const from = base ?? place(0, 0);
  const words = text.trim().replace(/^@/, "");
  const polar = words.split("<");
  if (polar.length === 2) return readPolar(polar, unit, from);
  const parts = words.split(",");
  if (parts.length !== 2) return { wrong: placeWords };
  const relative = text.trim().startsWith("@") ? from : place(0, 0);
  return both(readLength(parts[0] ?? "", unit), readLength(parts[1] ?? "", unit), (x, y) =>
    place(relative.x + x, relative.y + y),
  );
}

const readPolar = ([far = "", angle = ""]: readonly string[], unit: LengthUnit, from: Place) =>
  both(readLength(far, unit), readAngle(angle), (length, turn) => {
    const radians = (turn * Math.PI) / 180;
    return place(from.x + length * Math.cos(radians), from.y + length * Math.sin(radians));
  });

function both<A, B, T>(a: Read<A>, b: Read<B>, make: (a: A, b: B) => T): Read<T> {
  if (isWrong(a)) return a;
  return isWrong(b) ? b : { value: make(a.value, b.value) };
}
