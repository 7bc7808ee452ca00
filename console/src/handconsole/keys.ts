/** The keys of the hand console: as they lie, and where they are on a keyboard. */

import { t } from "../words/words";

export interface ConsoleKey {
  /** Name by which the server knows it. */
  readonly key: string;
  readonly label: string;
  /** Its name, where the label is a sign. */
  readonly name?: string;
}

const digit = (n: number): ConsoleKey => ({ key: `${n}`, label: `${n}` });
const sign: ConsoleKey = { key: "-", label: "+/−", name: t("Plus minus") };
const enter: ConsoleKey = { key: "\r", label: "Enter" };
const file: ConsoleKey = { key: "F", label: "File" };
const start: ConsoleKey = { key: "S", label: "Start" };
const stop: ConsoleKey = { key: "P", label: "Stop" };
const func: ConsoleKey = { key: "U", label: "Func" };

/** Row by row. */
export const pad: readonly ConsoleKey[] = [
  ...[7, 8, 9].map(digit),
  file,
  ...[4, 5, 6].map(digit),
  start,
  ...[1, 2, 3].map(digit),
  stop,
  sign,
  digit(0),
  enter,
  func,
];

const functionKeys: Record<string, ConsoleKey> = { F9: file, F10: start, F11: stop, F12: func };

const keypad: Record<string, ConsoleKey> = {
  NumpadEnter: enter,
  NumpadSubtract: sign,
  NumpadAdd: sign,
  // The point of a number, for which the console has no key of its own.
  NumpadDecimal: file,
  ...Object.fromEntries(pad.map((it) => [`Numpad${it.key}`, it])),
};

/**
 * The key of the console that a key of the keyboard is. The keypad is that of fields while somebody types
 * into one.
 */
export const keyOf = (code: string, typing: boolean): ConsoleKey | undefined =>
  functionKeys[code] ?? (typing ? undefined : keypad[code]);
