/**
 * Sentences of the server in the unit of the page. Inside there are millimetres, and so do its words tell
 * lengths; where a person reads inches they are put into inches here, in one place.
 */

import { isMetric, namedUnit } from "../units/quantity";
import type { Units } from "../wire/messages";

const number = String.raw`-?\d+(?:\.\d+)?`;

/** Numbers that share a unit: `5`, `20 x 30`, `7.62,-3.175`. */
const numbers = `${number}(?:(?: x | × |, ?| … )${number})*`;

const lengths = new RegExp(`(?<![\\w.])(${numbers}) mm(/s²|/s|/min)?(?![\\w²³/])`, "g");

/** Places of shapes, which are told without a unit. */
const places = new RegExp(`((?:shape|Form) \\d+ (?:at|bei) )(${number}),(${number})`, "gi");

/** Digits behind the point: a ten thousandth of an inch is 3 µm. */
const decimals = 4;

const inInches = (text: string, size: number): string =>
  text.replace(new RegExp(number, "g"), (one) =>
    String(Number((Number(one) / size).toFixed(decimals))),
  );

/** A sentence of the server as the person at this page reads it. */
export function inUnits(text: string, units: Units | undefined): string {
  if (!units) return text;
  const place = (_: string, words: string, x: string, y: string) => `${words}${x},${y} mm`;
  const told = text.replace(places, place);
  if (isMetric(units)) return told;
  return told.replace(lengths, (_, all: string, per: string | undefined) => {
    const { name, size } = namedUnit(`mm${per ?? ""}`, units);
    return `${inInches(all, size)} ${name}`;
  });
}
