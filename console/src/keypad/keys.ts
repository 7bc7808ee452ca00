/** Meanings of the keypad's keys (SK). */

import { t } from "../words/words";

/** Directions of X Y Z A B C: -1, 0, 1 or between. */
export type Direction = readonly [number, number, number, number, number, number];

/** Along one axis: X 0, Y 1 … */
export const directionOf = (n: number, sign: number): Direction => {
  const way = [0, 0, 0, 0, 0, 0];
  way[n] = sign;
  return way as unknown as Direction;
};

/** Both axes at the same speed as one alone. */
const slant = Math.SQRT1_2;
const diagonal = (x: number, y: number): Direction => [x * slant, y * slant, 0, 0, 0, 0];

export const directions = {
  left: directionOf(0, -1),
  right: directionOf(0, 1),
  down: directionOf(1, -1),
  up: directionOf(1, 1),
  lower: directionOf(2, -1),
  raise: directionOf(2, 1),
  accessoryDown: directionOf(3, -1),
  accessoryUp: directionOf(3, 1),
  rightUp: diagonal(1, 1),
  leftUp: diagonal(-1, 1),
  leftDown: diagonal(-1, -1),
  rightDown: diagonal(1, -1),
} as const;

export type Way = keyof typeof directions;

const plain: Record<string, Way> = {
  ArrowLeft: "left",
  ArrowRight: "right",
  ArrowDown: "down",
  ArrowUp: "up",
  PageDown: "lower",
  PageUp: "raise",
  "/": "rightUp",
  "\\": "leftUp",
};

/** With Alt: the accessory axis, and the diagonals reversed. */
const withAlt: Record<string, Way> = {
  PageDown: "accessoryDown",
  PageUp: "accessoryUp",
  "/": "leftDown",
  "\\": "rightDown",
};

/** The way that a key moves; `ctrlKey` makes it fast and does not change the way. */
export function wayOfKey(key: string, alt: boolean): Way | undefined {
  return alt ? (withAlt[key] ?? plain[key]) : plain[key];
}

/** Keys and their meanings, for the list of the keypad. */
export const keyHelp: readonly { readonly keys: string; readonly means: string }[] = [
  { keys: "← →", means: "X" },
  { keys: "↑ ↓", means: "Y" },
  { keys: t("PgUp PgDn"), means: "Z" },
  { keys: t("Ctrl + key"), means: t("at jog speed") },
  { keys: t("Alt + PgUp PgDn"), means: t("accessory axis A") },
  { keys: t("/ and \\"), means: t("diagonals; with Alt the other way") },
  { keys: "D", means: t("fixed distance on and off") },
  { keys: "E", means: t("the mouse as a pendant") },
  { keys: "#", means: t("record places: then 2 … 5 keeps a J2 … J5, 0 ends") },
  { keys: t("Esc"), means: t("leave; a part file goes on") },
];
