/**
 * From the millimetres and degrees of messages to what a person reads, and back.
 * A number of the server is never shown without passing here.
 */

import {
  type AxisValue,
  inAxisUnit,
  inUnit,
  isMetric,
  type LengthUnit,
  type Mm,
  type MmPerS,
  perSecondInUnit,
  type Seconds,
} from "../units/quantity";
import type { AxisUnits, Units } from "../wire/messages";

/** Digits behind the point of a location, as the location display of the manual has them. */
const decimals = 3;

/** A number in the unit of an axis, `-0` shown as `0`. */
export function locationText(internal: AxisValue, axis: AxisUnits): string {
  const text = inAxisUnit(internal, axis).toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

/** A speed as `1.50`, in linear units a second. */
export const speedText = (speed: MmPerS, unit: LengthUnit): string =>
  perSecondInUnit(speed, unit).toFixed(isMetric(unit) ? 1 : 2);

/** The number of a length, as `12.700`. */
export const numberText = (length: Mm, unit: LengthUnit, digits = 3): string =>
  inUnit(length, unit).toFixed(digits);

/** The number of a length with no zeros at its end, as `12.7`. */
export const shortText = (length: Mm, unit: LengthUnit, digits = 4): string =>
  String(Number(numberText(length, unit, digits)));

/** A length with its unit. */
export const lengthText = (length: Mm, unit: LengthUnit, digits = 2): string =>
  `${numberText(length, unit, digits)} ${unit.linear}`;

/** A place in the plane as people read it. */
export const placeText = ([x, y]: readonly [Mm, Mm], unit: LengthUnit, digits = 2): string =>
  `${numberText(x, unit, digits)}, ${lengthText(y, unit, digits)}`;

/** Seconds as `1:02:03`, or `2:03` below an hour. */
export function durationText(time: Seconds): string {
  const whole = Math.max(0, Math.ceil(time));
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (n: number) => String(n).padStart(2, "0");
  return h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`;
}

/** The axes that the machine has, with the place each has in messages. */
export function usedAxes(units: Units): { axis: AxisUnits; at: number }[] {
  return units.axes.map((axis, at) => ({ axis, at })).filter(({ axis }) => axis.used);
}
