/** A drawing for screens that need one: a plate with holes, and a bow tie. */

import { message, type Unmarked } from "../../src/units/testing";
import type { DrawingState, GroupState, ShapeList, ShapePath } from "../../src/wire/messages";

const group = (name: string, change: Partial<Unmarked<GroupState>> = {}): Unmarked<GroupState> => ({
  name,
  on: true,
  traversal: false,
  double: false,
  tool: 1,
  cut: 1,
  speedMmMin: null,
  height: "thru",
  pass: null,
  levels: [-30],
  offset: 0,
  rough: 0,
  tag: 0,
  leadIn: [0, 90],
  leadOut: [0, 90],
  ...change,
});

export const drawing = message<DrawingState>({
  name: "plate.dxf",
  revision: 1,
  begun: 1,
  shapes: 5,
  picked: [],
  selection: [2],
  canUndo: true,
  canRedo: false,
  changed: true,
  clipboard: 0,
  groups: [
    group("black", { offset: 3, leadIn: [5, 90] }),
    group("blue"),
    group("green"),
    group("cyan"),
    group("red", { height: -6, pass: 3, levels: [-23, -26] }),
    group("magenta"),
    group("brown", { on: false }),
    group("white"),
  ],
  comments: [],
  arrays: [],
  notes: [],
  block: { min: [0, 0], max: [200, 120], z: null },
  finish: [0, 0],
  join: 0.1,
});

const shape = (number: number, group: string, closed: boolean, points: number[]): ShapePath => ({
  number,
  group,
  closed,
  points,
  z: null,
  pause: false,
});

const hole = (number: number, x: number, y: number, r: number) =>
  shape(number, "red", true, [x + r, y, -1, x - r, y, -1]);

export const shapes: ShapeList = {
  revision: 1,
  shapes: [
    hole(1, 40, 40, 15),
    hole(2, 160, 40, 15),
    shape(
      3,
      "black",
      true,
      [
        20, 0, 0, 180, 0, 0.414214, 200, 20, 0, 200, 100, 0.414214, 180, 120, 0, 20, 120, 0.414214,
        0, 100, 0, 0, 20, 0.414214,
      ],
    ),
    shape(4, "blue", true, [80, 70, 0, 120, 100, 0, 120, 70, 0, 80, 100, 0]),
    shape(5, "brown", false, [10, 110, 0, 60, 80, 0.5, 100, 60, 0]),
  ],
};
