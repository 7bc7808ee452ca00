/** The desk in a component: state, and what hands do to it. */

import { useCallback, useMemo, useRef, useState } from "react";
import { ask } from "../actions/ask";
import { useHands, worldOf } from "../app/context";
import { type Around, type DeskState, type Done, firstDesk } from "./desk";
import { pickable, type Scene } from "./scene";

export interface Desk {
  readonly state: DeskState;
  readonly around: Around;
  /** Makes a step: its operations go to the server, its words to the person. */
  act(step: (state: DeskState, around: Around) => Done | null): boolean;
  set(change: (state: DeskState) => DeskState): void;
  /** Sends operations. */
  send(clauses: string): void;
}

/** What the server tells that hands go by. */
export type Ways = Pick<Around, "pickRadius" | "lastJoin" | "picked" | "expansion">;

export function useDesk(scene: Scene, { pickRadius, lastJoin, picked, expansion }: Ways): Desk {
  const hands = useHands();
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
      void ask(worldOf(hands), { do: "draw", op: { op: "do", clauses } });
    },
    [hands],
  );
  const act: Desk["act"] = useCallback(
    (step) => {
      const done = step(now.current, around);
      if (!done) return false;
      put(done.state);
      if (done.clauses !== undefined) send(done.clauses);
      if (done.words !== undefined) hands.screen.tell(done.words);
      return true;
    },
    [around, hands, put, send],
  );
  const set: Desk["set"] = useCallback((change) => put(change(now.current)), [put]);
  return useMemo(() => ({ state, around, act, set, send }), [state, around, act, set, send]);
}
