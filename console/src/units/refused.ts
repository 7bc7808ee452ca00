/** Lines that the compiler has to refuse: `npm run check` fails when it takes one of them. */

import type { Motion, Units } from "../wire/messages";
import {
  type AxisSpeeds,
  type AxisValue,
  degrees,
  difference,
  inUnit,
  type Mm,
  mm,
  ofUnit,
  perMinute,
  perMinuteInUnit,
  perSecondInUnit,
  type Seconds,
  seconds,
  shown,
  type UnixSeconds,
} from "./quantity";

export function refused(units: Units, motion: Motion, speeds: AxisSpeeds, angle: AxisValue): void {
  // @ts-expect-error a plain number is no length
  inUnit(5, units);
  // @ts-expect-error a length of the page is none in millimetres
  inUnit(shown(5), units);
  // @ts-expect-error a length in millimetres is none of the page
  ofUnit(mm(5), units);
  // @ts-expect-error a number that has a unit gets no other
  mm(shown(5));
  // @ts-expect-error a speed is no length
  inUnit(motion.speedMmS, units);
  // @ts-expect-error a length is no speed
  perSecondInUnit(mm(5), units);
  // @ts-expect-error a speed a minute is none a second
  perSecondInUnit(perMinute(motion.speedMmS), units);
  // @ts-expect-error a speed a second is none a minute
  perMinuteInUnit(motion.speedMmS, units);
  // @ts-expect-error a speed that an axis turns with is none along a path
  perSecondInUnit(speeds[2], units);
  // @ts-expect-error an axis that may turn has no length
  inUnit(angle, units);
  // @ts-expect-error an angle is no length
  inUnit(degrees(90), units);
  // @ts-expect-error a time is no length
  inUnit(motion.t, units);
  // @ts-expect-error a length of time is no moment
  const moment: UnixSeconds = motion.elapsed;
  // @ts-expect-error a moment is no length of time
  const time: Seconds = moment;
  // @ts-expect-error between a length and a time there is no difference
  difference(mm(5), seconds(5));
  // @ts-expect-error nothing but the doors divides by the unit of the page
  const plain: number = 5 / units.mm;
  // @ts-expect-error arithmetic gives a plain number
  const length: Mm = mm(5) + plain;
  void [time, length];
}
