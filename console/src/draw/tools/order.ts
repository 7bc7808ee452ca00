/** Tools for the way in which shapes are cut: starts, directions, pauses, order, groups. */

import { t } from "../../words/words";
import { numbersOf, placeOf, select, shapeAt, type Tool, xy } from "./tool";

const shapes = { ask: "shapes", prompt: t("Shapes") } as const;

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
  title: t("Start"),
  doc: t("Where the cut of a shape begins; of an open one, at which end."),
  menu: "path",
  asks: [{ ask: "shape", prompt: t("Place of the start") }],
  repeats: true,
  clauses: ([where]) => {
    const { number, at } = shapeAt(where);
    return `start ${number} ${xy(at)}`;
  },
};

const directions: Tool = {
  id: "directions",
  title: t("Directions"),
  doc: t("Outer shapes counter-clockwise, those within clockwise."),
  menu: "path",
  asks: [],
  clauses: () => "directions auto",
};

const inOrder: Tool = {
  id: "sequence",
  title: t("Order by hand"),
  doc: t("Pick the shapes in the order of cutting; picked again, a shape is taken out."),
  menu: "sequence",
  asks: [{ ask: "shapes", prompt: t("Shapes in cutting order"), numbered: true }],
  clauses: ([picked]) => `sequence ${numbersOf(picked).join(",")}`,
};

const byGroups: Tool = {
  id: "sequence-groups",
  title: t("Order of layers"),
  doc: t("Pick a shape of each layer in the order of cutting."),
  menu: "sequence",
  asks: [{ ask: "shapes", prompt: t("A shape of each layer"), numbered: true }],
  clauses: ([picked]) => `sequence groups of ${numbersOf(picked).join(",")}`,
};

const inLevel: Tool = {
  id: "sequence-level",
  title: t("Order of a level"),
  doc: t(
    "Pick shapes that lie in the same shape in the order of cutting; what lies in them goes along.",
  ),
  menu: "sequence",
  asks: [{ ask: "shapes", prompt: t("Shapes of one level"), numbered: true }],
  clauses: ([picked]) => `sequence level ${numbersOf(picked).join(",")}`,
};

const fromPlace: Tool = {
  id: "sequence-auto",
  title: t("Order from a place"),
  doc: t("Nearest to the place first, inner shapes before those round them."),
  menu: "sequence",
  asks: [{ ask: "place", prompt: t("Place S") }],
  clauses: ([at]) => `sequence auto ${xy(placeOf(at))}`,
};

const reversed: Tool = {
  id: "sequence-reverse",
  title: t("Reverse the order"),
  doc: t("The last shape is cut first."),
  menu: "sequence",
  asks: [],
  clauses: () => "sequence reverse",
};

export const orderTools: readonly Tool[] = [
  start,
  onShapes("reverse", t("Reverse"), t("Turns the cutting direction."), "reverse"),
  directions,
  onShapes("pause", t("Pause before"), t("The machine halts before the shapes."), "pause on"),
  onShapes(
    "no-pause",
    t("No pause"),
    t("The machine does not halt before the shapes."),
    "pause off",
  ),
  inOrder,
  byGroups,
  inLevel,
  fromPlace,
  reversed,
];
