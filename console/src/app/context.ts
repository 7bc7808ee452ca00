/** Hands the world to components, and slices of it so that they draw only when theirs changes. */

import { createContext, useCallback, useContext, useSyncExternalStore } from "react";
import type { World } from "../actions/action";
import type { Link } from "../link/link";
import type { Shown } from "../link/shown";
import { nothingShown } from "../link/shown";
import type { Snapshot } from "../wire/messages";
import type { Screen, ScreenState } from "./screen";

export interface Hands {
  readonly link: Link;
  readonly screen: Screen;
}

export const HandsContext = createContext<Hands | null>(null);

export function useHands(): Hands {
  const hands = useContext(HandsContext);
  if (!hands) throw new Error("a component stands outside of the console");
  return hands;
}

/** The world as it is now, for an action. */
export const worldOf = ({ link, screen }: Hands): World => ({
  shown: link.shown.get(),
  link,
  screen,
});

/** A slice of what the server told. The slice must be one of its objects or a plain value. */
export function useShown<T>(slice: (shown: Shown) => T): T {
  const { shown } = useHands().link;
  const read = useCallback(() => slice(shown.get()), [shown, slice]);
  return useSyncExternalStore(shown.watch, read, () => slice(nothingShown));
}

/** A section of the snapshot; nothing before the first one arrived. */
export function useSnapshot<K extends keyof Snapshot>(section: K): Snapshot[K] | undefined {
  return useShown(useCallback((shown: Shown) => shown.snapshot?.[section], [section]));
}

/** A slice of what this browser shows. */
export function useScreen<K extends keyof ScreenState>(part: K): ScreenState[K] {
  const { screen } = useHands();
  return useSyncExternalStore(screen.watch, () => screen.get()[part]);
}
