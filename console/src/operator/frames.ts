/** The frames in which the location display tells where the tool is. */

import { type AxisValue, difference, type Mm, mm } from "../units/quantity";
import type { Motion, Opened, Snapshot } from "../wire/messages";
import { t } from "../words/words";
import { isUnderWay } from "./fileStatus";

/** `job` counts X and Y from the origin of the open job, the others from home, as jobs do. */
export type Frame = "job" | "working" | "base";

export const titles: Record<Frame, string> = {
  job: t("From the job origin"),
  working: t("Location"),
  base: t("Table base location"),
};

interface FrameChoice {
  readonly value: Frame;
  readonly words: string;
}

const always: readonly FrameChoice[] = [
  { value: "working", words: "Working" },
  { value: "base", words: "Base" },
];

/** Those that there are: the job's while one is open. */
export const framesOf = (opened: Opened | null): readonly FrameChoice[] =>
  opened?.origin ? [{ value: "job", words: "Job" }, ...always] : always;

/** The places of the axes in a frame. A job that runs may have taken its origin where it began. */
export function placeIn(
  frame: Frame,
  { at }: Motion,
  { opened, job }: Pick<Snapshot, "opened" | "job">,
): readonly AxisValue[] {
  if (frame !== "job") return at[frame];
  const origin: readonly Mm[] = opened?.origin ?? [];
  const runs = isUnderWay(job) && job.hash === opened?.hash;
  return at.machine.map((value, n) =>
    n > 1 ? value : runs ? (at.working[n] ?? value) : difference(value, origin[n] ?? mm(0)),
  );
}
