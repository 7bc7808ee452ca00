/** The viewing options of the drawing, kept in this browser. */

import { createStore, type Store } from "../app/store";
import { t } from "../words/words";

export interface ViewOptions {
  /** Group colours instead of those of the directions. */
  readonly groupColours: boolean;
  readonly starts: boolean;
  readonly vertices: boolean;
  /** Vertices that are left out when paths are made. */
  readonly filtered: boolean;
  /** Curves that short lines become when paths are made. */
  readonly smoothed: boolean;
  /** Shapes of groups that are off, dashed; without it they are not shown. */
  readonly offDashed: boolean;
  readonly toolPaths: boolean;
  /** Paths of rough passes besides the final ones. */
  readonly rough: boolean;
  /** The bounds of the machine, its home, the job's origin and finish, and the tool. */
  readonly machine: boolean;
}

export type ViewOption = keyof ViewOptions;

interface OptionWords {
  readonly title: string;
  readonly doc: string;
}

export const optionWords: Record<ViewOption, OptionWords> = {
  groupColours: { title: t("Layer colours"), doc: t("Instead of the colours of the directions") },
  starts: {
    title: t("Starts"),
    doc: t("Where each shape begins, its direction and the cutting side"),
  },
  vertices: { title: t("Vertices"), doc: t("A small cross at each") },
  filtered: { title: t("Filtered"), doc: t("Vertices that are left out when paths are made") },
  smoothed: { title: t("Smoothed"), doc: t("Curves that short lines become when paths are made") },
  offDashed: { title: t("Layers off"), doc: t("Dashed; else they are not shown and not picked") },
  toolPaths: {
    title: t("Tool paths"),
    doc: t("As the machine would cut, made anew with every change"),
  },
  rough: { title: t("Rough passes"), doc: t("The paths of rough passes besides the final ones") },
  machine: {
    title: t("Machine"),
    doc: t("Its bounds, home, origin and finish of the job, the tool"),
  },
};

const usual: ViewOptions = {
  groupColours: false,
  starts: true,
  vertices: false,
  filtered: false,
  smoothed: false,
  offDashed: true,
  toolPaths: true,
  rough: false,
  machine: false,
};

/** Tells whether the view shows something that the server makes of the drawing. */
export const showsMachined = ({ toolPaths, rough, smoothed, filtered }: ViewOptions): boolean =>
  toolPaths || rough || smoothed || filtered;

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
