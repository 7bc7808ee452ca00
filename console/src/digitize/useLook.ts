/** Brings into sight the part of the drawing that the hand console asks for, once each time. */

import { useEffect, useRef } from "react";
import { useSnapshot } from "../app/context";
import type { Look } from "../wire/messages";

/** Calls `look` for each new request; requests from before the page was there are passed over. */
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
