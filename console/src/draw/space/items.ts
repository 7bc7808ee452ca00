/** Items of a drawing in space: shapes and paths at their heights, the levels, the machine. */

import type { Bounds, Vec3 } from "../../view/camera";
import type { GroupState, ZHeights } from "../../wire/messages";
import { isEmpty } from "../geometry/vec";
import { hidden, pathStrokes, type Stroke, shapeStroke, type Token } from "../picture";
import type { Scene } from "../scene";
import { lifted } from "./lift";

export type Item =
  | {
      readonly kind: Stroke["kind"];
      readonly ink: Token;
      readonly dash: boolean;
      readonly line: readonly Vec3[];
    }
  /** One of the special heights, as a frame round the drawing. */
  | {
      readonly kind: "level";
      readonly name: "ZTop" | "ZSurface" | "ZBottom";
      readonly z: number;
      readonly ink: Token;
      readonly line: readonly Vec3[];
    }
  /** Place of the machine. */
  | { readonly kind: "machine"; readonly at: Vec3; readonly ink: Token };

export interface Setting {
  readonly groups: readonly GroupState[];
  readonly heights: ZHeights;
  /** Place of the tool: the drawing's X and Y, Z from the machine's home. */
  readonly machine: Vec3 | null;
}

export function itemsOf(scene: Scene, setting: Setting): Item[] {
  const seen = scene.shapes.filter((shape) => !hidden(scene, shape));
  const strokes = [...pathStrokes(scene), ...seen.map((shape) => shapeStroke(scene, shape))];
  return [
    ...levelItems(scene, setting.heights),
    ...strokes.flatMap((stroke) => raised(stroke, setting)),
    ...machineItems(setting),
  ];
}

function raised({ kind, shape, ink, dash }: Stroke, { groups, heights }: Setting): Item[] {
  const group = groups.find(({ name }) => name === shape.group);
  const lines = lifted(shape, group ?? { levels: [heights.bottom] }, heights);
  return lines.map((line) => ({ kind, ink, dash, line }));
}

const machineItems = ({ machine }: Setting): Item[] =>
  machine ? [{ kind: "machine", at: machine, ink: "--view-tool" }] : [];

/** Distance of the levels' frames from the drawing: a share of its size. */
const margin = 0.06;

function levelItems({ box }: Scene, { top, surface, bottom }: ZHeights): Item[] {
  const [x0, y0, x1, y1] = isEmpty(box)
    ? [0, 0, 100, 100]
    : [box.min.x, box.min.y, box.max.x, box.max.y];
  const by = margin * Math.max(x1 - x0, y1 - y0, 1);
  const frame = (z: number): Vec3[] => [
    [x0 - by, y0 - by, z],
    [x1 + by, y0 - by, z],
    [x1 + by, y1 + by, z],
    [x0 - by, y1 + by, z],
    [x0 - by, y0 - by, z],
  ];
  return [
    { kind: "level", name: "ZTop", z: top, ink: "--draw-level-top", line: frame(top) },
    { kind: "level", name: "ZSurface", z: surface, ink: "--draw-level", line: frame(surface) },
    { kind: "level", name: "ZBottom", z: bottom, ink: "--draw-level", line: frame(bottom) },
  ];
}

/** The smallest box round everything but the machine. */
export function boundsOfItems(items: readonly Item[]): Bounds {
  const places = items.flatMap((item) => (item.kind === "machine" ? [] : item.line));
  const [first = [0, 0, 0]] = places;
  const min: [number, number, number] = [...first];
  const max: [number, number, number] = [...first];
  for (const at of places) {
    for (const axis of [0, 1, 2] as const) {
      min[axis] = Math.min(min[axis], at[axis]);
      max[axis] = Math.max(max[axis], at[axis]);
    }
  }
  return { min, max };
}
