/** The job that is open, read again when it or the machine changed. */

import { useEffect, useMemo, useState } from "react";
import { useHands, useShown, useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import type { JobView } from "../wire/messages";
import { type Plan, planOf, type Standing, standingOf } from "./plan";

/** Nothing while no job is open. */
export function useJob(): Plan | null {
  const opened = useSnapshot("opened");
  const settings = useSnapshot("settings");
  const { screen } = useHands();
  const [plan, setPlan] = useState<Plan | null>(null);
  const wanted = opened?.kind === "job" ? opened.hash : null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: heights and speeds are settings
  useEffect(() => {
    if (wanted === null) return setPlan(null);
    const gone = new AbortController();
    getJson<JobView>("/api/job", gone.signal)
      .then((view) => setPlan(planOf(view)))
      .catch((error: Error) => gone.signal.aborted || screen.tell(error.message));
    return () => gone.abort();
  }, [wanted, settings, screen]);
  return plan;
}

/** The progress of the machine in the paths of a job. */
export function useStanding(plan: Plan | null): Standing {
  const job = useSnapshot("job");
  const line = useShown((shown) => shown.snapshot?.motion.line ?? 0);
  const opened = useSnapshot("opened");
  const snapshot = useShown((shown) => shown.snapshot);
  // biome-ignore lint/correctness/useExhaustiveDependencies: only what a standing is made of
  return useMemo(() => standingOf(snapshot, plan), [job, line, opened, plan]);
}
