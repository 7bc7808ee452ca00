import { useEffect, useMemo, useState, useSyncExternalStore } from "react";
import { useShown, useSnapshot } from "../app/context";
import type { Vec3 } from "./camera";
import { followTyped, type Typed } from "./typed";

export interface TypedView {
  readonly path: Typed;
  /** The way of the move under way so far. */
  readonly live: readonly Vec3[];
}

/** Follows the typed moves as they are made. */
export function useTyped(): TypedView {
  const [following] = useState(() => followTyped());
  const told = useSnapshot("typed");
  useEffect(() => {
    if (told) following.told(told);
  }, [following, told]);
  const path = useSyncExternalStore(following.path.watch, following.path.get);
  const live = useLive(path);
  return useMemo(() => ({ path, live }), [path, live]);
}

const none: readonly Vec3[] = [];

/** The places of the tool since the last move that is drawn, while a typed line moves it. */
function useLive(path: Typed): readonly Vec3[] {
  const at = useSnapshot("motion")?.at;
  const moves = useShown(({ snapshot }) => {
    const job = snapshot?.job;
    const typed = job?.command != null && job.hash === null && job.ended === null;
    return typed && snapshot?.machine.state === "running";
  });
  const [live, setLive] = useState(none);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a move that is drawn ends the way to it
  useEffect(() => setLive(none), [path, moves]);
  useEffect(() => {
    if (moves && at) setLive((now) => [...now, placeOf(at.machine)]);
  }, [moves, at]);
  return live;
}

const placeOf = (place: readonly number[]): Vec3 => [place[0] ?? 0, place[1] ?? 0, place[2] ?? 0];
