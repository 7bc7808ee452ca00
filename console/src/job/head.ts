/** The place of the head, seen from the path that a job begins with. */

import type { JobView } from "../wire/messages";

/** A head nearer than this stands over a place, mm. */
export const near = 0.01;

export interface Head {
  /** Its place from the job origin, mm. */
  readonly at: readonly [number, number];
  /** Distance to the beginning of the path, mm. */
  readonly awayMm: number;
}

/** The head of a machine that stands at a place, mm from home; nothing where the job has no such path. */
export function headAt(
  { origin, paths }: Pick<JobView, "origin" | "paths">,
  number: number,
  [x, y]: readonly [number, number],
): Head | null {
  const [startX, startY] = paths[number - 1]?.points ?? [];
  if (startX === undefined || startY === undefined) return null;
  const at = [x - origin[0], y - origin[1]] as const;
  return { at, awayMm: Math.hypot(at[0] - startX, at[1] - startY) };
}
