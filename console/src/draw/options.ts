/** The viewing options of the drawing, kept in this browser. */

import { createStore, type Store } from "../app/store";

export interface ViewOptions {
  /** Group colours instead of those of the directions. */
  readonly groupColours: boolean;
  readonly starts: boolean;
  readonly vertices: boolean;
  /** Shapes of groups that are off, dashed; without it they are not shown. */
  readonly offDashed: boolean;
  readonly toolPaths: boolean;
}

export type ViewOption = keyof ViewOptions;

export const optionWords: Record<ViewOption, string> = {
  groupColours: "Group colours",
  starts: "Starts",
  vertices: "Vertices",
  offDashed: "Groups that are off",
  toolPaths: "Tool paths",
};

const usual: ViewOptions = {
  groupColours: false,
  starts: true,
  vertices: false,
  offDashed: true,
  toolPaths: false,
};

const key = "kerf.draw.view";

function remembered(): ViewOptions {
  try {
    return { ...usual, ...(JSON.parse(localStorage.getItem(key) ?? "{}") as Partial<ViewOptions>) };
  } catch {
    return usual;
  }
}

/** Options that are written down whenever they change. */
export function createOptions(): Store<ViewOptions> {
  const store = createStore(remembered());
  store.watch(() => localStorage.setItem(key, JSON.stringify(store.get())));
  return store;
}
