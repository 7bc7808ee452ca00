/** State of a chart: the stretch it shows, and the moment it reads. */

import { type RefObject, useEffect, useState } from "react";
import { fitted, type Span, whole } from "./span";

/** The stretch that is shown; it stays when the chart is made anew. */
export function useSpan(end: number) {
  const [span, setSpan] = useState<Span>(() => whole(end));
  const [before, setBefore] = useState(end);
  if (before !== end) {
    setBefore(end);
    setSpan(fitted(span, before, end));
  }
  return [span, setSpan] as const;
}

/** The moment that is read: under the pointer, or where keys bring it, which alone is told aloud. */
export function useCursor() {
  const [cursor, setCursor] = useState<{ at: number | null; told: boolean }>({
    at: null,
    told: false,
  });
  return {
    ...cursor,
    point: (at: number | null) => setCursor({ at, told: false }),
    step: (at: number) => setCursor({ at, told: true }),
  };
}

/** The chart comes after its sheet: it takes the focus where nothing in the sheet has it yet. */
export function useFocusAtFirst(chart: RefObject<HTMLElement | null>) {
  useEffect(() => {
    const here = document.activeElement;
    const sheet = chart.current?.closest("[role=dialog]");
    if (!here || here === document.body || here === sheet) chart.current?.focus();
  }, [chart]);
}
