/** The desk in a component: state, and what hands do to it. */

import { useCallback, useMemo, useRef, useState } from "react";
import { ask } from "../actions/ask";
import { useHands, worldOf } from "../app/context";
import { type Around, type DeskState, type Done, firstDesk } from "./desk";
import { pickable, type Scene } from "./scene";
import { useTurns } from "./useTurns";

export interface Desk {
  readonly state: DeskState;
  readonly around: Around;
  /** Steps wait for what was asked for before them. */
  readonly waits: boolean;
  /** Makes a step in its turn: its operations go to the server, its words to the person. */
  act(step: (state: DeskState, around: Around) => Done | null): void;
  /** Changes the state at once; gives the one before. */
  set(change: (state: DeskState) => DeskState): DeskState;
  /** Sends operations. */
  send(clauses: string): void;
}

/** Settings of the server that the desk's tools follow. */
export type Ways = Pick<Around, "pickRadius" | "lastJoin" | "picked" | "expansion">;

/** `fresh` tells that the scene shows the newest shapes. */
export function useDesk(scene: Scene, ways: Ways, fresh: boolean): Desk {
  const { pickRadius, lastJoin, picked, expansion } = ways;
  const hands = useHands();
  const turns = useTurns(fresh);
  const [state, setState] = useState(firstDesk);
  const now = useRef(state);
  const around = useMemo<Around>(
    () => ({
      picking: pickable(scene),
      selected: [...scene.selected],
      picked,
      box: scene.box,
      pickRadius,
      lastJoin,
      expansion,
    }),
    [scene, pickRadius, lastJoin, picked, expansion],
  );
  const put = useCallback((next: DeskState) => {
    now.current = next;
    setState(next);
  }, []);
  const send = useCallback(
    (clauses: string) => {
      turns.asked(ask(worldOf(hands), { do: "draw", op: { op: "do", clauses } }));
    },
    [hands, turns],
  );
  const shown = useRef(around);
  shown.current = around;
  const act: Desk["act"] = useCallback(
    (step) =>
      turns.take(() => {
        const done = step(now.current, shown.current);
        if (!done) return;
        put(done.state);
        if (done.clauses !== undefined) send(done.clauses);
        if (done.words !== undefined) hands.screen.tell(done.words);
      }),
    [hands, put, send, turns],
  );
  const set: Desk["set"] = useCallback(
    (change) => {
      const before = now.current;
      put(change(before));
      return before;
    },
    [put],
  );
  const waits = turns.wait;
  return useMemo(
    () => ({ state, around, waits, act, set, send }),
    [state, around, waits, act, set, send],
  );
}
