/** Sizes and times of files, for people. */

import type { UnixSeconds } from "../units/quantity";
import type { FileAbout } from "../wire/messages";
import { language, t } from "../words/words";

export const sizeText = (bytes: number): string =>
  bytes < 1e3
    ? `${bytes} B`
    : bytes < 1e6
      ? t("{0} kB", (bytes / 1e3).toFixed(0))
      : t("{0} MB", (bytes / 1e6).toFixed(1));

/** A moment as it is said now: `today 14:03`, else with the day. */
export function timeText(moment: UnixSeconds, now = new Date()): string {
  const time = new Date(moment * 1000);
  const clock = time.toLocaleTimeString(language, { hour: "2-digit", minute: "2-digit" });
  const isToday = time.toDateString() === now.toDateString();
  return isToday ? t("today {0}", clock) : `${time.toLocaleDateString(language)} ${clock}`;
}

/** `a part program of 412 lines, 8 kB, changed today 14:03`. */
export const aboutText = ({ what, bytes, changed }: FileAbout): string =>
  t("{0}, {1}, changed {2}", what, sizeText(bytes), timeText(changed));
