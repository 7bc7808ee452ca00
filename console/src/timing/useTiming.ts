import { useEffect, useState } from "react";
import { getJson, Outdated, Refused } from "../link/http";
import type { Timing } from "../wire/messages";
import { t } from "../words/words";

/** Reading of a file's timing; while it is made anew, it keeps the one before. */
export type Reading = { readonly of: string | undefined } & (
  | { readonly state: "reading"; readonly before: Timing | undefined }
  | { readonly state: "ready"; readonly timing: Timing }
  | { readonly state: "failed"; readonly why: string }
);

/** The chart that there is to show. */
export function timingOf(reading: Reading): Timing | undefined {
  if (reading.state === "ready") return reading.timing;
  return reading.state === "reading" ? reading.before : undefined;
}

const began = (of: string | undefined, now?: Reading): Reading => ({
  of,
  state: "reading",
  before: now?.of === of && now ? timingOf(now) : undefined,
});

/**
 * The timing of a file's preview as it arrives; nothing without a preview. The simulated machine's inputs
 * change as they say.
 */
export function useTiming(
  name: string | undefined,
  key: string | undefined,
  inputs: string,
): Reading {
  const [reading, setReading] = useState<Reading>(() => began(name));
  useEffect(() => {
    setReading((now) => began(name, now));
    if (key === undefined) return;
    const gone = new AbortController();
    const failed = (error: Error) => {
      const why = error instanceof Refused ? error.message : t("The server does not answer.");
      // In the place of a preview that is outdated the next one comes.
      if (gone.signal.aborted || error instanceof Outdated) return;
      setReading({ of: name, state: "failed", why });
    };
    const asked = inputs === "" ? "" : `?inputs=${encodeURIComponent(inputs)}`;
    getJson<Timing>(`/api/preview/${key}/timing${asked}`, gone.signal).then(
      (timing) => setReading({ of: name, state: "ready", timing }),
      failed,
    );
    return () => gone.abort();
  }, [name, key, inputs]);
  return reading.of === name ? reading : began(name);
}
