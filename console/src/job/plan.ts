/** The job that is open as its page shows it: paths that can be seen, picked and followed. */

import { boxOfShapes, type Shape, shapeOf } from "../draw/geometry/shape";
import { type Box, type Place, place } from "../draw/geometry/vec";
import { type Picking, pickingOf, pieceDistance } from "../draw/pick";
import type { JobView, Snapshot } from "../wire/messages";

/** So much larger than the job is what shows all of it: numbers stand beside the paths. */
export const margin = 1.3;

export interface PlannedPath {
  readonly shape: Shape;
  /** It is followed and not cut. */
  readonly traversal: boolean;
  readonly tool: number;
}

export interface Plan {
  readonly view: JobView;
  /** In cutting order; the number of each is its place. */
  readonly paths: readonly PlannedPath[];
  /** Names of groups that have paths, in the order in which they are cut first. */
  readonly groups: readonly string[];
  readonly box: Box;
  readonly picking: Picking;
}

export function planOf(view: JobView): Plan {
  const paths = view.paths.map(({ traversal, tool, ...path }) => ({
    shape: shapeOf(path),
    traversal,
    tool,
  }));
  const shapes = paths.map(({ shape }) => shape);
  return {
    view,
    paths,
    groups: [...new Set(shapes.map(({ group }) => group))],
    box: boxOfShapes(shapes),
    picking: pickingOf(shapes),
  };
}

/** The number of the path nearest to a place; of several equally near ones the first that is cut. */
export function pathAt({ picking }: Plan, at: Place, radius: number): number | null {
  const [nearest] = picking
    .near(at, radius)
    .map((piece) => ({ number: piece.shape.number, far: pieceDistance(piece, at) }))
    .sort((a, b) => a.far - b.far || a.number - b.number);
  return nearest?.number ?? null;
}

/** Progress of a job: the path that is made, and the one with which it begins. */
export interface Standing {
  readonly runs: boolean;
  /** The path that is made, or was made last; 0 before the first. */
  readonly at: number;
  readonly start: number;
  /** It was cut to its end. */
  readonly finished: boolean;
}

export type Share = "skipped" | "waiting" | "running" | "done";

/** Tells if a path is skipped, done, running or still to come. */
export function shareOf(number: number, { runs, at, start, finished }: Standing): Share {
  if (number < start) return "skipped";
  if (finished) return "done";
  if (!runs || number > at) return "waiting";
  return number === at ? "running" : "done";
}

/** Progress of the open job, by the server's snapshot. */
export function standingOf(snapshot: Snapshot | null, plan: Plan | null): Standing {
  const { job, motion, opened } = snapshot ?? {};
  const mine = job?.hash !== null && job?.hash === opened?.hash;
  return {
    runs: mine && job?.ended === null,
    at: mine ? (motion?.line ?? 0) : 0,
    start: plan?.view.start ?? 1,
    finished: mine && job?.ended === "ok",
  };
}

/** Place of the tool, from the job's origin. */
export function toolPlace(snapshot: Snapshot | null, plan: Plan | null): Place | null {
  const at = snapshot?.motion.at.machine;
  const [x, y] = plan?.view.origin ?? [0, 0];
  return at ? place(at[0] - x, at[1] - y) : null;
}
