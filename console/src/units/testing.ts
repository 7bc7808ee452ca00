/** Messages that tests write in place of the server, with plain numbers for those with units. */

import type { UnitSize } from "./quantity";

/** A message whose numbers have no units. */
export type Unmarked<T> = T extends number | UnitSize
  ? number
  : T extends object
    ? { [K in keyof T]: Unmarked<T[K]> }
    : T;

/** The message that a test writes. */
export const message = <T>(unmarked: Unmarked<T>): T => unmarked as T;
