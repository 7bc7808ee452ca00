/** Sizes and times of files, for people. */

import type { FileAbout } from "../wire/messages";

export const sizeText = (bytes: number): string =>
  bytes < 1e3
    ? `${bytes} B`
    : bytes < 1e6
      ? `${(bytes / 1e3).toFixed(0)} kB`
      : `${(bytes / 1e6).toFixed(1)} MB`;

/** A time, seconds since 1970, as it is said now: `today 14:03`, else with the day. */
export function timeText(seconds: number, now = new Date()): string {
  const time = new Date(seconds * 1000);
  const clock = time.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
  const isToday = time.toDateString() === now.toDateString();
  return isToday ? `today ${clock}` : `${time.toLocaleDateString()} ${clock}`;
}

/** `a part program of 412 lines, 8 kB, changed today 14:03`. */
export const aboutText = ({ what, bytes, changed }: FileAbout): string =>
  `${what}, ${sizeText(bytes)}, changed ${timeText(changed)}`;
