/** Files of the part folder that were opened last, the newest first; this browser keeps them. */

import type { Store } from "../app/store";
import type { Shown } from "../link/shown";

const key = "kerf.recent";

/** Names that are kept. */
const most = 6;

/** The list with a name at its head, once. */
export const withNewest = (list: readonly string[], name: string): string[] =>
  [name, ...list.filter((other) => other !== name)].slice(0, most);

export function recentFiles(): readonly string[] {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(key) ?? "[]");
    return Array.isArray(kept) ? kept.filter((name) => typeof name === "string") : [];
  } catch {
    // Another program may have written there: what it wrote is no list.
    return [];
  }
}

/** Keeps the names of files and of drawings as they are opened, by whomever. */
export function keepRecent(shown: Store<Shown>): void {
  keepNames(shown, (now) => now.snapshot?.opened?.name);
  keepNames(shown, (now) => now.snapshot?.drawing?.name);
}

function keepNames(shown: Store<Shown>, of: (now: Shown) => string | null | undefined): void {
  let open = "";
  shown.watch(() => {
    const name = of(shown.get()) ?? "";
    if (name === open) return;
    open = name;
    if (name !== "") localStorage.setItem(key, JSON.stringify(withNewest(recentFiles(), name)));
  });
}
