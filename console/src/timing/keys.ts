/** The keys of the timing chart. */

import { t } from "../words/words";
import { panned, type Span, whole, zoomed } from "./span";

/** Moves the stretch that is shown; `end` is that of the run. */
type Move = (span: Span, end: number) => Span;

const about = (factor: number): Move => {
  return (span, end) => zoomed(span, (span.from + span.to) / 2, factor, end);
};

export const closer = about(1.5);
export const further = about(1 / 1.5);
export const earlier: Move = (span, end) => panned(span, -0.25, end);
export const later: Move = (span, end) => panned(span, 0.25, end);
export const all: Move = (_, end) => whole(end);

const moves: Readonly<Record<string, Move>> = {
  "+": closer,
  "=": closer,
  "-": further,
  ArrowLeft: earlier,
  ArrowRight: later,
  PageUp: (span, end) => panned(span, -1, end),
  PageDown: (span, end) => panned(span, 1, end),
  Home: ({ from, to }) => ({ from: 0, to: to - from }),
  End: ({ from, to }, end) => ({ from: end - (to - from), to: end }),
  "0": all,
};

/** Gives the cursor's new moment for Shift and this key; from nowhere it begins in the middle. */
export function cursorOfKey(key: string): ((at: number | null, span: Span) => number) | undefined {
  const by = { ArrowLeft: -1, ArrowRight: 1 }[key];
  if (by === undefined) return undefined;
  return (at, { from, to }) => {
    const next = (at ?? (from + to) / 2) + (at === null ? 0 : (by * (to - from)) / 50);
    return Math.min(Math.max(next, from), to);
  };
}

/** Finds the move of a key, if it has one. */
export const moveOfKey = (key: string): Move | undefined => moves[key];

/** The keys as the help lists them. */
export const keyHelp: readonly { keys: string; means: string }[] = [
  { keys: "+ −", means: t("More or less detail") },
  { keys: "← →", means: t("Earlier, later") },
  { keys: t("Shift with ← →"), means: t("What everything is, a little earlier, later") },
  { keys: t("Page Up, Page Down"), means: t("A whole width earlier, later") },
  { keys: t("Home, End"), means: t("The beginning, the end") },
  { keys: "0", means: t("All of it") },
];
