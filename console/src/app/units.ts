/**
 * From the millimetres and degrees of messages to what a person reads, and back.
 * A number of the server is never shown without passing here.
 */

import type { AxisUnits, Units } from "../wire/messages";

/** Digits behind the point of a location, as the location display of the manual has them. */
const decimals = 3;

/** A number in the unit of an axis, `-0` shown as `0`. */
export function locationText(internal: number, axis: AxisUnits): string {
  const text = (internal / axis.scale).toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

/** A speed as `1.50`, in linear units a second. */
export const speedText = (mmPerSecond: number, units: Units): string =>
  (mmPerSecond / units.mm).toFixed(units.mm === 1 ? 1 : 2);

/** Millimetres as a length with its unit. */
export const lengthText = (mm: number, units: Units, digits = 2): string =>
  `${(mm / units.mm).toFixed(digits)} ${units.linear}`;

/** A place in the plane, mm, as people read it. */
export const placeText = ([x, y]: readonly [number, number], units: Units): string =>
  `${(x / units.mm).toFixed(2)}, ${lengthText(y, units)}`;

/** Seconds as `1:02:03`, or `2:03` below an hour. */
export function durationText(seconds: number): string {
  const whole = Math.max(0, Math.ceil(seconds));
  const [h, m, s] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (n: number) => String(n).padStart(2, "0");
  return h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`;
}

/** The axes that the machine has, with the place each has in messages. */
export function usedAxes(units: Units): { axis: AxisUnits; at: number }[] {
  return units.axes.map((axis, at) => ({ axis, at })).filter(({ axis }) => axis.used);
}
