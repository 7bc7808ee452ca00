/** Steps of the hand, each in its turn. */

import { useCallback, useEffect, useMemo, useRef, useState } from "react";

/** Takes a step with the drawing as it is shown now. */
type Take = () => void;

export interface Turns {
  /** Something waits for its turn. */
  readonly wait: boolean;
  /** Takes the step now, or as soon as the page shows what was asked for before. */
  take(step: Take): void;
  /** Steps that are taken from now on wait for this; what waits is dropped when it was refused. */
  asked(done: Promise<boolean>): void;
}

/**
 * Lets a step wait while what it looks at is older than what was asked for. Hands are quicker than a slow link: a
 * click that follows an operation means the drawing that comes of it. `fresh` tells that the newest shapes are shown.
 */
export function useTurns(fresh: boolean): Turns {
  const waiting = useRef<Take[]>([]);
  const owed = useRef(0);
  const isFresh = useRef(fresh);
  isFresh.current = fresh;
  const [wait, setWait] = useState(false);
  const [, setReplies] = useState(0);
  const isReady = useCallback(() => isFresh.current && owed.current === 0, []);
  useEffect(() => {
    while (isReady() && waiting.current.length > 0) waiting.current.shift()?.();
    setWait(waiting.current.length > 0);
  });
  const take = useCallback(
    (step: Take) => {
      if (isReady() && waiting.current.length === 0) return step();
      waiting.current.push(step);
      setWait(true);
    },
    [isReady],
  );
  const asked = useCallback((done: Promise<boolean>) => {
    owed.current += 1;
    void done.then((isDone) => {
      owed.current -= 1;
      // What followed was meant for what did not come about.
      if (!isDone) waiting.current = [];
      setReplies((count) => count + 1);
    });
  }, []);
  return useMemo(() => ({ wait, take, asked }), [wait, take, asked]);
}
