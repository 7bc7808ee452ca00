/** The place of the head, seen from the path that a job begins with. */

import { difference, type Mm, mm } from "../units/quantity";
import type { JobView } from "../wire/messages";

/** A head nearer than this stands over a place. */
export const near = mm(0.01);

export interface Head {
  /** Its place from the job origin. */
  readonly at: readonly [Mm, Mm];
  /** Distance to the beginning of the path. */
  readonly awayMm: Mm;
}

/** The head of a machine that stands at a place, from home; nothing where the job has no such path. */
export function headAt(
  { origin, paths }: Pick<JobView, "origin" | "paths">,
  number: number,
  [x, y]: readonly [Mm, Mm],
): Head | null {
  const [startX, startY] = paths[number - 1]?.points ?? [];
  if (startX === undefined || startY === undefined) return null;
  const at = [difference(x, origin[0]), difference(y, origin[1])] as const;
  return { at, awayMm: mm(Math.hypot(at[0] - startX, at[1] - startY)) };
}
