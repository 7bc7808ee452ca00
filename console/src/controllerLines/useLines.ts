import { useEffect, useRef, useState } from "react";
import { getJson, Refused } from "../link/http";
import type { ControllerLine, ControllerLines } from "../wire/messages";
import { kept } from "./lines";

/** Time between two questions for further lines, milliseconds. */
const eachMs = 300;

/** The same where the server does not answer. */
const silentMs = 1000;

export interface Lines {
  readonly lines: readonly ControllerLine[];
  /** Lines that the server does not keep any more. */
  readonly gone: number;
  /** Reason for which there are none. */
  readonly refusal?: string;
}

const nothing: Lines = { lines: [], gone: 0 };

/**
 * Reads the lines between Kerf and the controller as they come, for as long as somebody looks; with `routine` also reports and
 * each `ok`. Nothing is asked for while it is paused.
 */
export function useLines(routine: boolean, paused: boolean): Lines {
  const [state, setState] = useState(nothing);
  const asked = useRef({ routine, next: 0 });
  useEffect(() => {
    if (paused) return;
    const gone = new AbortController();
    // Other kinds are wanted: from the oldest line on.
    if (asked.current.routine !== routine) {
      asked.current = { routine, next: 0 };
      setState(nothing);
    }
    const take = async () => {
      const since = asked.current.next;
      const address = `/api/lines?since=${since}${routine ? "&routine=1" : ""}`;
      const told = await getJson<ControllerLines>(address, gone.signal);
      if (gone.signal.aborted) return;
      // A server that has started anew counts anew: from its first line on.
      const anew = told.next < since;
      asked.current = { routine, next: anew ? 0 : told.next };
      setState((now) => (anew ? nothing : { lines: kept(now.lines, told.lines), gone: told.gone }));
      if (!told.more) await pause(eachMs);
    };
    const follow = async () => {
      while (!gone.signal.aborted) {
        const refusal = await take().catch((error: Error) => error);
        if (refusal instanceof Refused) return setState({ ...nothing, refusal: refusal.message });
        if (refusal) await pause(silentMs);
      }
    };
    void follow();
    return () => gone.abort();
  }, [routine, paused]);
  return state;
}

const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
