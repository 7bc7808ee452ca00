/** The keys of actions as the person at this browser has set them; those of the sources where nothing else was set. */

import { t } from "../words/words";
import type { Action } from "./action";

const storageKey = "kerf.keys";

/** Keys by the action's id; an empty list where an action has none any more. */
type Bindings = Readonly<Record<string, readonly string[]>>;

function read(): Bindings {
  const kept = typeof localStorage === "undefined" ? null : localStorage.getItem(storageKey);
  try {
    return kept === null ? {} : (JSON.parse(kept) as Bindings);
  } catch {
    return {};
  }
}

let bindings = read();

export const keysOf = ({ id, keys = [] }: Action): readonly string[] => bindings[id] ?? keys;

/** Tells whether an action has other keys than those of the sources. */
export const isRebound = ({ id }: Action): boolean => bindings[id] !== undefined;

/** STOP has the space bar, and nobody else gets it; these leave fields and sheets, or go between them. */
const taken: readonly string[] = ["Space", "Escape", "Enter", "Tab", "Shift+Tab"];

/** STOP keeps its keys. */
export const isFixed = ({ keys = [] }: Action): boolean => keys.includes("Space");

/** The reason for which an action cannot get a key; nothing when it can. A key may mean something else at times. */
export function refusedKey(
  actions: readonly Action[],
  action: Action,
  key: string,
): string | undefined {
  if (taken.includes(key)) return t("{0} keeps its meaning.", key);
  const clash = actions.find(
    (other) =>
      other.id !== action.id && !other.when === !action.when && keysOf(other).includes(key),
  );
  return clash && t("{0} means: {1}. Take it away there first.", key, clash.title);
}

function keep(next: Bindings): void {
  bindings = next;
  localStorage.setItem(storageKey, JSON.stringify(next));
}

/** Gives an action this key and no other; none with nothing. */
export const bind = ({ id }: Action, key: string | undefined): void =>
  keep({ ...bindings, [id]: key === undefined ? [] : [key] });

/** Gives every action the keys of the sources again. */
export const unbindAll = (): void => keep({});
