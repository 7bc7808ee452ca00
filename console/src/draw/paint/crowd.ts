/** Thins out marks that lie on each other: of a crowd, those in one small square of the screen look like one. */

import type { Place } from "../geometry/vec";
import type { Mark } from "../picture";

/** So many marks are painted as they are. */
const crowd = 2000;

/** Side of a square, pixels. */
const square = 6;

/** The marks of a crowd, one at the most in each square; boxes stay. */
export function apart(marks: readonly Mark[], pixelOf: (at: Place) => Place): readonly Mark[] {
  if (marks.length <= crowd) return marks;
  const taken = new Set<string>();
  return marks.filter((mark) => {
    if (mark.kind === "bbox") return true;
    const { x, y } = pixelOf(mark.at);
    const key = `${mark.kind} ${Math.floor(x / square)} ${Math.floor(y / square)}`;
    const isFirst = !taken.has(key);
    taken.add(key);
    return isFirst;
  });
}
