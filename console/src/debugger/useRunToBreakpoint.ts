import { useEffect, useState } from "react";
import type { Asked } from "../wire/messages";

/**
 * Steps on by itself until a line with a breakpoint is due. When this page goes away, the job waits
 * at its next line.
 */
export function useRunToBreakpoint(
  asked: Asked | undefined,
  breakpoints: readonly number[],
  step: () => Promise<boolean>,
) {
  const [runs, setRuns] = useState(false);
  // A step that is refused ends it: nothing would ask for the next one.
  const go = () => void step().then((done) => done || setRuns(false));
  // biome-ignore lint/correctness/useExhaustiveDependencies: every question is answered once
  useEffect(() => {
    if (!runs || !asked) return;
    if (breakpoints.includes(asked.line)) setRuns(false);
    else go();
  }, [runs, asked?.number]);
  return {
    runs,
    /** Leaves the line that is due first, or a breakpoint on it would hold at once. */
    begin: () => {
      setRuns(true);
      go();
    },
    halt: () => setRuns(false),
  };
}
