import { useEffect, useRef } from "react";
import { ask } from "../actions/ask";
import { useHands, useScreen, useSnapshot, worldOf } from "../app/context";
import type { Asked } from "../wire/messages";

/**
 * Steps on by itself until a line with a breakpoint is due, over lines that move and other questions. When
 * this page goes away, the job waits at its next line.
 */
export function useStepsOn(due: Asked | null) {
  const hands = useHands();
  const { screen } = hands;
  const job = useSnapshot("job");
  const breakpoints = useScreen("breakpoints");
  const run = job && job.ended === null ? job.run : null;
  const runs = useScreen("steppedRun") === run && run !== null;
  const answered = useRef(0);
  const answer = (words: string) => {
    if (!due) return;
    answered.current = due.number;
    const asked = ask(worldOf(hands), { do: "answer", question: due.number, answer: words });
    // A step that is refused ends it: nothing would ask for the next one.
    void asked.then((done) => done || screen.stepOn(null));
  };
  // biome-ignore lint/correctness/useExhaustiveDependencies: every question is answered once
  useEffect(() => {
    if (!runs || !due || answered.current === due.number) return;
    if (breakpoints.some(({ file, line }) => file === due.file && line === due.line))
      screen.stepOn(null);
    else answer("Step");
  }, [runs, due?.number]);
  return {
    runs,
    answer,
    /** Leaves the line that is due first, or a breakpoint on it would hold at once. */
    begin: () => {
      answer("Step");
      screen.stepOn(run);
    },
    halt: () => screen.stepOn(null),
  };
}
