/** What the canvas shows, made from what the server tells. */

import type { DrawingState, ShapeList } from "../wire/messages";
import { crossesItself } from "./geometry/crossing";
import { boxOfShapes, type Shape, shapeOf } from "./geometry/shape";
import type { ViewOptions } from "./options";
import { hidden, type Scene } from "./paint/shapes";
import { type Picking, pickingOf } from "./pick";

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

export function sceneOf(
  { shapes, crossing }: Loaded,
  drawing: DrawingState | null | undefined,
  toolPaths: readonly Shape[],
  options: ViewOptions,
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
    toolPaths,
    options,
  };
}

/** The index of what can be picked: what is in sight. */
export const pickable = (scene: Scene): Picking =>
  pickingOf(scene.shapes.filter((shape) => !hidden(scene, shape)));
