import { useEffect, useState } from "react";
import { getJson, Refused } from "../link/http";
import type { Timing } from "../wire/messages";

export type Reading =
  | { readonly state: "reading" }
  | { readonly state: "ready"; readonly timing: Timing }
  | { readonly state: "failed"; readonly why: string };

/** The timing of a preview as it arrives; nothing without a preview. The simulated machine's inputs change as they say. */
export function useTiming(key: string | undefined, inputs: string): Reading {
  const [reading, setReading] = useState<Reading>({ state: "reading" });
  useEffect(() => {
    setReading({ state: "reading" });
    if (key === undefined) return;
    const gone = new AbortController();
    const failed = (error: Error) => {
      const why = error instanceof Refused ? error.message : "The server does not answer.";
      if (!gone.signal.aborted) setReading({ state: "failed", why });
    };
    const asked = inputs === "" ? "" : `?inputs=${encodeURIComponent(inputs)}`;
    getJson<Timing>(`/api/preview/${key}/timing${asked}`, gone.signal).then(
      (timing) => setReading({ state: "ready", timing }),
      failed,
    );
    return () => gone.abort();
  }, [key, inputs]);
  return reading;
}
