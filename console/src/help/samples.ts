/** Jobs to try: files that come with the console, each with a picture of its tool path. */

import { t } from "../words/words";

export interface Sample {
  readonly title: string;
  /** Its files: the first is opened, it may call the others. */
  readonly files: readonly string[];
  readonly about: string;
}

export const samples: readonly Sample[] = [
  { title: t("First cut"), files: ["first-cut.sbp"], about: t("The outline of a rectangle.") },
  {
    title: t("Rounded sign"),
    files: ["rounded-sign.sbp"],
    about: t("Arcs, an arch, holes in spirals."),
  },
  {
    title: t("Coaster"),
    files: ["coaster.sbp"],
    about: t("A circular pocket, cut out with tabs."),
  },
  {
    title: t("Grid of holes"),
    files: ["hole-grid.sbp"],
    about: t("Variables, loops, a subroutine."),
  },
  {
    title: t("Leaves"),
    files: ["leaves.sbp", "leaf.sbp"],
    about: t("One file three times, moved and scaled."),
  },
  { title: t("Touch plate"), files: ["touch-plate.sbp"], about: t("Finds the stock and sets Z.") },
  { title: t("Questions"), files: ["questions.sbp"], about: t("Asks for sizes, then cuts.") },
  { title: t("G-code"), files: ["g-code.nc"], about: t("A drilling cycle, a loop, a subroutine.") },
  { title: t("Slots"), files: ["to-gcode.sbp"], about: t("A loop that converts to G-code.") },
  {
    title: t("Bracket"),
    files: ["from-a-drawing.rsg"],
    about: t("A drawing, with layers and an array."),
  },
];

const texts = import.meta.glob<string>("../../../examples/*/*.{sbp,nc,rsg}", {
  query: "?raw",
  import: "default",
});

/** The text of a file of a sample. */
export async function sampleText(file: string): Promise<string> {
  const [, read] = Object.entries(texts).find(([path]) => path.endsWith(`/${file}`)) ?? [];
  if (!read) throw new Error(`there is no sample ${file}`);
  return read();
}

/** The address of the picture of a sample. */
export const pictureOf = ({ files }: Sample): string =>
  `/samples/${files[0]?.replace(/\.[a-z]+$/, "")}.svg`;
