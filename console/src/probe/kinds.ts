/** Kinds of things that the probe finds: name, entries of TP that it needs, and picture of each. */

import type { CommandEntry } from "../wire/messages";
import { t } from "../words/words";

/** A line of a picture from here to there, in a field of 120 by 80. */
type Way = readonly [number, number, number, number];

/** A picture, seen from above; of a plate, from the side. */
interface Scene {
  /** The outline of what is touched; what is solid of it is filled. */
  readonly solid: string;
  /** The place of the tool at the beginning. */
  readonly tool: readonly [number, number];
  /** Touches, in their order, as arrows. */
  readonly touches: readonly Way[];
}

export interface Kind {
  /** Its word in TP. */
  readonly word: string;
  readonly name: string;
  /** The sentence that tells the place of the tool before the start. */
  readonly begins: string;
  /** Names of the entries that it needs beside those of every kind. */
  readonly needs: readonly string[];
  readonly scene: Scene;
}

const always = ["Travel", "Clearance", "First touch, a second", "Second touch, a second"];
const axes = "Sets zero of";
const diameter = "Probe, diameter";
const plate = "Plate, thickness";

export const kinds: readonly Kind[] = [
  {
    word: "plate",
    name: t("Plate or surface, Z"),
    begins: t("The tool stands above it."),
    needs: [axes, plate],
    scene: {
      solid: "M10 60H110V75H10ZM45 52H75V60H45Z",
      tool: [60, 14],
      touches: [[60, 20, 60, 50]],
    },
  },
  {
    word: "outside-corner",
    name: t("Outside corner, X Y Z"),
    begins: t("The tool stands above the material, inset from both edges."),
    needs: [axes, "Corner", plate, diameter, "Inset", "Depth"],
    scene: {
      solid: "M40 10H110V60H40Z",
      tool: [56, 44],
      touches: [
        [18, 44, 38, 44],
        [56, 78, 56, 62],
      ],
    },
  },
  {
    word: "inside-corner",
    name: t("Inside corner, X Y"),
    begins: t("The tool stands in the corner, at the depth of the touch."),
    needs: [axes, "Corner", diameter],
    scene: {
      solid: "M10 5H30V58H110V75H10Z",
      tool: [62, 32],
      touches: [
        [56, 32, 33, 32],
        [62, 38, 62, 56],
      ],
    },
  },
  {
    word: "edge",
    name: t("Edge, X or Y"),
    begins: t("The tool stands beside it, at the depth of the touch."),
    needs: [axes, "Direction", diameter],
    scene: { solid: "M70 5H110V75H70Z", tool: [24, 40], touches: [[30, 40, 67, 40]] },
  },
  {
    word: "bore",
    name: t("Bore, its middle"),
    begins: t("The tool stands in it, at the depth of the touch."),
    needs: [axes, diameter],
    scene: {
      solid: "M10 5H110V75H10ZM60 12A28 28 0 1 0 60 68A28 28 0 1 0 60 12Z",
      tool: [60, 40],
      touches: [
        [66, 40, 86, 40],
        [54, 40, 34, 40],
        [60, 34, 60, 14],
        [60, 46, 60, 66],
      ],
    },
  },
  {
    word: "boss",
    name: t("Boss, its middle"),
    begins: t("The tool stands above its middle."),
    needs: [axes, diameter, "Size", "Inset", "Depth"],
    scene: {
      solid: "M60 20A20 20 0 1 0 60 60A20 20 0 1 0 60 20Z",
      tool: [60, 40],
      touches: [
        [104, 40, 82, 40],
        [16, 40, 38, 40],
        [60, 2, 60, 18],
        [60, 78, 60, 62],
      ],
    },
  },
  {
    word: "slot",
    name: t("Slot, its middle"),
    begins: t("The tool stands in it, at the depth of the touch."),
    needs: [axes, "Direction", diameter],
    scene: {
      solid: "M10 5H34V75H10ZM86 5H110V75H86Z",
      tool: [60, 40],
      touches: [
        [66, 40, 83, 40],
        [54, 40, 37, 40],
      ],
    },
  },
  {
    word: "angle",
    name: t("Angle of the material"),
    begins: t(
      "The tool stands beside it, at the depth of the touch; the second touch is Size further.",
    ),
    needs: [axes, "Direction", "Size"],
    scene: {
      solid: "M66 5H110V75H78Z",
      tool: [24, 62],
      touches: [
        [30, 62, 74, 62],
        [30, 20, 67, 20],
      ],
    },
  },
];

/** Places of the entries of a kind, in the order of the form. */
export const entriesOf = (kind: Kind, { parameters }: CommandEntry): number[] =>
  parameters.flatMap(({ name }, n) => ([...kind.needs, ...always].includes(name) ? [n] : []));
