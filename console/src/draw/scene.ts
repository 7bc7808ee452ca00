/** Scene of the canvas, made from the server's snapshot. */

import { type DigitizedItem, digitizedItem } from "../digitize/points";
import type { Digitized, DrawingState, ShapeList, ToolPaths } from "../wire/messages";
import { crossesItself } from "./geometry/crossing";
import { boxOfShapes, type Shape, shapeOf } from "./geometry/shape";
import { type Box, type Place, place } from "./geometry/vec";
import type { ViewOptions } from "./options";
import { type Picking, pickingOf } from "./pick";
import { hidden } from "./picture";

/** The shapes of one revision, with what is costly to find out about them. */
export interface Loaded {
  readonly revision: number;
  readonly shapes: readonly Shape[];
  readonly crossing: ReadonlySet<number>;
}

export const nothingLoaded: Loaded = { revision: -1, shapes: [], crossing: new Set() };

export function loadedOf(list: ShapeList): Loaded {
  const shapes = list.shapes.map(shapeOf);
  const crossing = new Set(shapes.filter(crossesItself).map(({ number }) => number));
  return { revision: list.revision, shapes, crossing };
}

/** A path of the tool. */
export interface CutPath {
  readonly shape: Shape;
  readonly pass: "rough" | "final" | "traversal";
}

/** Tool paths of the drawing as it is machined, with the notes made on the way. */
export interface Machined {
  readonly paths: readonly CutPath[];
  readonly smoothed: readonly Shape[];
  readonly filtered: readonly Place[];
  readonly notes: readonly string[];
}

export const notMachined: Machined = { paths: [], smoothed: [], filtered: [], notes: [] };

export function machinedOf({ paths, smoothed, filtered, notes }: ToolPaths): Machined {
  return {
    paths: paths.map(({ pass, ...path }) => ({ pass, shape: shapeOf(path) })),
    smoothed: smoothed.map(shapeOf),
    filtered: Array.from({ length: filtered.length / 2 }, (_, n) =>
      place(filtered[2 * n] ?? 0, filtered[2 * n + 1] ?? 0),
    ),
    notes,
  };
}

/** Everything about a drawing that does not move with the mouse. */
export interface Scene extends Omit<Machined, "notes"> {
  readonly shapes: readonly Shape[];
  /** Numbers of closed shapes that cross themselves. */
  readonly crossing: ReadonlySet<number>;
  readonly selected: ReadonlySet<number>;
  /** Groups that are switched off. */
  readonly off: ReadonlySet<string>;
  /** Groups whose tool path lies to the left of travel. */
  readonly leftOf: ReadonlySet<string>;
  readonly box: Box;
  readonly options: ViewOptions;
  /** Points that are being digitized. */
  readonly digitized: DigitizedItem | null;
}

export function sceneOf(
  { shapes, crossing }: Loaded,
  drawing: DrawingState | null | undefined,
  { paths, smoothed, filtered }: Machined,
  options: ViewOptions,
  digitized: Digitized | null = null,
): Scene {
  const groups = drawing?.groups ?? [];
  const named = (which: (group: (typeof groups)[number]) => boolean) =>
    new Set(groups.filter(which).map(({ name }) => name));
  return {
    shapes,
    crossing,
    selected: new Set(drawing?.selection ?? []),
    off: named((group) => !group.on),
    leftOf: named((group) => group.offset < 0),
    box: boxOfShapes(shapes),
    paths,
    smoothed,
    filtered,
    options,
    digitized: digitized && digitizedItem(digitized),
  };
}

/** The index of what can be picked: what is in sight. */
export const pickable = (scene: Scene): Picking =>
  pickingOf(scene.shapes.filter((shape) => !hidden(scene, shape)));
