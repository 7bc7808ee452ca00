/** Heights of a surface at the places of a grid, as a page shows and keeps them. */

import { numberText } from "../app/units";
import { difference, isMetric, type LengthUnit, type Mm, mm } from "../units/quantity";
import type { HeightMap, PreviewInfo } from "../wire/messages";

/** A place of a surface: X, Y and Z from working zero. */
export type Place = readonly [Mm, Mm, Mm];

/** Digits that show a thousandth of an inch, or a hundredth of a millimetre. */
const decimals = (unit: LengthUnit): number => (isMetric(unit) ? 2 : 4);

/** A height in the unit of the page, with its sign. */
export function heightText(height: Mm, unit: LengthUnit): string {
  const text = numberText(height, unit, decimals(unit));
  if (Number(text) === 0) return text.replace("-", "");
  return Number(text) < 0 ? text.replace("-", "−") : `+${text}`;
}

/** Lowest and highest height with their unit, as `−0.12 … +0.31 mm`. */
export const rangeText = (lowest: Mm, highest: Mm, unit: LengthUnit): string =>
  `${heightText(lowest, unit)} … ${heightText(highest, unit)} ${unit.linear}`;

/** The places of a map, row by row. */
export const placesOf = ({ xs, ys, zs }: HeightMap): Place[] =>
  zs.map((z, n) => [xs[n % xs.length] ?? mm(0), ys[Math.floor(n / xs.length)] ?? mm(0), z]);

/** The file of heights that holds these places. */
export const fileText = (places: readonly Place[]): string =>
  ["kerf heights, mm", ...places.map((place) => place.join(","))].join("\n").concat("\n");

const head = "Height: ";
/** A probing program begins with it: `Heights of 35 places`. */
const begins = /^Heights of (\d+) places$/;

/** Places that a probing program has printed since it began, as `Height: 0,10,-0.1`, and how many it will. */
export function probedPlaces(printed: readonly string[]): { places: Place[]; of: number } {
  const first = printed.findLastIndex((line) => begins.test(line));
  const lines = printed.slice(first + 1).filter((line) => line.startsWith(head));
  const places = lines.map((line) => {
    const [x = Number.NaN, y = Number.NaN, z = Number.NaN] = line
      .slice(head.length)
      .split(",")
      .map(Number);
    return [mm(x), mm(y), mm(z)] as const;
  });
  return {
    places: places.filter((place) => place.every(Number.isFinite)),
    of: Number(begins.exec(printed[first] ?? "")?.[1] ?? places.length),
  };
}

/** Distance between two places of a new grid, at most, and its fewest and most rows. */
const pitchMm = 20;
const [fewest, most] = [2, 15];

const countOf = (length: Mm): number =>
  Math.min(most, Math.max(fewest, Math.ceil(length / pitchMm) + 1));

/** Entries of a grid over the cuts of a preview, by their names; nothing where it cuts nothing. */
export function gridOver(
  { bounds }: PreviewInfo,
  zero: readonly [Mm, Mm],
  unit: LengthUnit,
): Readonly<Record<string, string>> | undefined {
  if (!bounds) return undefined;
  const [low, high] = bounds;
  const number = (length: Mm) => numberText(length, unit, 4).replace(/\.?0+$/, "");
  const size = (n: 0 | 1) => difference(high[n], low[n]);
  return {
    X: number(difference(low[0], zero[0])),
    Y: number(difference(low[1], zero[1])),
    "Width, X": number(size(0)),
    "Height, Y": number(size(1)),
    Columns: String(countOf(size(0))),
    Rows: String(countOf(size(1))),
    Units: "as set",
  };
}

/** The share of a height between the lowest and the highest, 0 … 1. */
export const shareOf = (z: number, lowest: number, highest: number): number =>
  highest > lowest ? (z - lowest) / (highest - lowest) : 0.5;
