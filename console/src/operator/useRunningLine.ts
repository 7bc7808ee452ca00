import { useShown } from "../app/context";
import type { Shown } from "../link/shown";

/** The line of the open file that makes the present move; 0 when it does not run. */
export const useRunningLine = (): number => useShown(runningLine);

export function runningLine({ snapshot }: Shown): number {
  const job = snapshot?.job;
  if (!snapshot || !job || job.ended !== null || job.command !== null) return 0;
  const { line } = snapshot.motion;
  return line > 0 ? line : (job.calls[0]?.line ?? 0);
}
