/** Jobs to try: files that come with the console, each with a picture of its tool path. */

export interface Sample {
  readonly title: string;
  /** Its files: the first is opened, it may call the others. */
  readonly files: readonly string[];
  readonly about: string;
}

export const samples: readonly Sample[] = [
  { title: "First cut", files: ["first-cut.sbp"], about: "The outline of a rectangle." },
  { title: "Rounded sign", files: ["rounded-sign.sbp"], about: "Arcs, an arch, holes in spirals." },
  { title: "Coaster", files: ["coaster.sbp"], about: "A circular pocket, cut out with tabs." },
  { title: "Grid of holes", files: ["hole-grid.sbp"], about: "Variables, loops, a subroutine." },
  {
    title: "Leaves",
    files: ["leaves.sbp", "leaf.sbp"],
    about: "One file three times, moved and scaled.",
  },
  { title: "Touch plate", files: ["touch-plate.sbp"], about: "Finds the stock and sets Z." },
  { title: "Questions", files: ["questions.sbp"], about: "Asks for sizes, then cuts." },
  { title: "G-code", files: ["g-code.nc"], about: "A drilling cycle, a loop, a subroutine." },
  { title: "Slots", files: ["to-gcode.sbp"], about: "A loop that converts to G-code." },
  {
    title: "Bracket",
    files: ["from-a-drawing.rsg"],
    about: "A drawing, with layers and an array.",
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
