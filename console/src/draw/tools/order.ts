/** Tools for the way in which shapes are cut: starts, directions, pauses, order, groups. */

import { numbersOf, placeOf, select, shapeAt, type Tool, xy } from "./tool";

const shapes = { ask: "shapes", prompt: "Shapes" } as const;

/** An operation on the shapes that were picked. */
const onShapes = (id: string, title: string, doc: string, operation: string): Tool => ({
  id,
  title,
  doc,
  menu: "path",
  asks: [shapes],
  clauses: ([picked]) => `${select(numbersOf(picked))}; ${operation}`,
});

const start: Tool = {
  id: "start",
  title: "Start",
  doc: "Where the cut of a shape begins; of an open one, at which end.",
  menu: "path",
  asks: [{ ask: "shape", prompt: "Place of the start" }],
  repeats: true,
  clauses: ([where]) => {
    const { number, at } = shapeAt(where);
    return `start ${number} ${xy(at)}`;
  },
};

const directions: Tool = {
  id: "directions",
  title: "Directions",
  doc: "Outer shapes counter-clockwise, those within clockwise.",
  menu: "path",
  asks: [],
  clauses: () => "directions auto",
};

const inOrder: Tool = {
  id: "sequence",
  title: "Order by hand",
  doc: "Pick the shapes in the order of cutting; picked again, a shape is taken out.",
  menu: "sequence",
  asks: [{ ask: "shapes", prompt: "Shapes in cutting order", numbered: true }],
  clauses: ([picked]) => `sequence ${numbersOf(picked).join(",")}`,
};

const byGroups: Tool = {
  id: "sequence-groups",
  title: "Order of groups",
  doc: "Pick a shape of each group in the order of cutting.",
  menu: "sequence",
  asks: [{ ask: "shapes", prompt: "A shape of each group", numbered: true }],
  clauses: ([picked]) => `sequence groups of ${numbersOf(picked).join(",")}`,
};

const inLevel: Tool = {
  id: "sequence-level",
  title: "Order of a level",
  doc: "Pick shapes that lie in the same shape in the order of cutting; what lies in them goes along.",
  menu: "sequence",
  asks: [{ ask: "shapes", prompt: "Shapes of one level", numbered: true }],
  clauses: ([picked]) => `sequence level ${numbersOf(picked).join(",")}`,
};

const fromPlace: Tool = {
  id: "sequence-auto",
  title: "Order from a place",
  doc: "Nearest to the place first, inner shapes before those round them.",
  menu: "sequence",
  asks: [{ ask: "place", prompt: "Place S" }],
  clauses: ([at]) => `sequence auto ${xy(placeOf(at))}`,
};

const reversed: Tool = {
  id: "sequence-reverse",
  title: "Reverse the order",
  doc: "The last shape is cut first.",
  menu: "sequence",
  asks: [],
  clauses: () => "sequence reverse",
};

export const orderTools: readonly Tool[] = [
  start,
  onShapes("reverse", "Reverse", "Turns the cutting direction.", "reverse"),
  directions,
  onShapes("pause", "Pause before", "The machine halts before the shapes.", "pause on"),
  onShapes("no-pause", "No pause", "The machine does not halt before the shapes.", "pause off"),
  inOrder,
  byGroups,
  inLevel,
  fromPlace,
  reversed,
];
