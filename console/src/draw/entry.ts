/**
 * What a person types for a place or a number.
 *
 * Places: `x,y`, `@dx,dy` from the last place, `len<angle` from the last place. Numbers are
 * expressions; each term has a unit of its own or the user's: `3/4in+2mm`, `(10+5)/2`.
 */

import { evaluate } from "../app/expression";
import { t } from "../words/words";
import { type Place, place } from "./geometry/vec";

/** A reading, or words that say what is wrong. */
export type Read<T> = { readonly value: T } | { readonly wrong: string };

export const isWrong = <T>(read: Read<T>): read is { readonly wrong: string } => "wrong" in read;

/** Parts of a millimetre that nobody can type on purpose are left out. */
const finest = 1e9;

const readAs = (text: string, unitMm: number): Read<number> => {
  const value = evaluate(text, { mm: unitMm });
  if (value === undefined) return { wrong: t("“{0}” is no number.", text.trim()) };
  // Units of units: 2mm in inches is 2 mm again, not 1.9999999999999998.
  return { value: Math.round(value * unitMm * finest) / finest };
};

/** A length: millimetres. `unitMm` is the user's unit. */
export const readLength = (text: string, unitMm: number): Read<number> => readAs(text, unitMm);

/** A number without a unit: degrees, a factor, a count, a bulge. */
export const readNumber = (text: string): Read<number> => readAs(text, 1);

const placeWords = t("A place is x,y or @dx,dy or length<angle.");

/** A place. `base` is the last place, from which `@` and `<` count; else from the origin. */
export function readPlace(text: string, unitMm: number, base: Place | null): Read<Place> {
  const from = base ?? place(0, 0);
  const words = text.trim().replace(/^@/, "");
  const polar = words.split("<");
  if (polar.length === 2) return readPolar(polar, unitMm, from);
  const parts = words.split(",");
  if (parts.length !== 2) return { wrong: placeWords };
  const relative = text.trim().startsWith("@") ? from : place(0, 0);
  return both(readLength(parts[0] ?? "", unitMm), readLength(parts[1] ?? "", unitMm), (x, y) =>
    place(relative.x + x, relative.y + y),
  );
}

const readPolar = ([far = "", angle = ""]: readonly string[], unitMm: number, from: Place) =>
  both(readLength(far, unitMm), readNumber(angle), (length, degrees) => {
    const radians = (degrees * Math.PI) / 180;
    return place(from.x + length * Math.cos(radians), from.y + length * Math.sin(radians));
  });

function both<T>(a: Read<number>, b: Read<number>, make: (a: number, b: number) => T): Read<T> {
  if (isWrong(a)) return a;
  return isWrong(b) ? b : { value: make(a.value, b.value) };
}
