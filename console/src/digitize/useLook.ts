/** What the hand console wants in sight, once each time. */

import { useEffect, useRef } from "react";
import { useSnapshot } from "../app/context";
import type { Look } from "../wire/messages";

/** What was looked at before the page was there stays as it is. */
export function useLook(look: (at: Look) => void): void {
  const looked = useSnapshot("looked");
  const number = looked?.number ?? 0;
  const seen = useRef(number);
  // biome-ignore lint/correctness/useExhaustiveDependencies: once for each look
  useEffect(() => {
    if (!looked || number === seen.current) return;
    seen.current = number;
    look(looked.at);
  }, [number]);
}
