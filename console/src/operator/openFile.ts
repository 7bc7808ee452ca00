/** Opens a file of the part folder as what it is. */

import { ask } from "../actions/ask";
import { type Hands, worldOf } from "../app/context";
import type { FileInfo } from "../wire/messages";
import { baseOf, parentOf } from "./folder";

/** Opens a drawing on its own screen; the one on the sheet goes. */
export async function openDrawing(hands: Hands, name: string): Promise<void> {
  if (!(await ask(worldOf(hands), { do: "draw", op: { op: "open", name } }))) return;
  hands.screen.open(null);
  hands.screen.go("/draw");
}

/** Opens a program or a job to be run: with the sheet of FP where there are command keys. */
export async function openToRun(hands: Hands, name: string, folder: string): Promise<void> {
  const { screen } = hands;
  // Where a file is chosen, the next one is looked for (FS).
  if (parentOf(name) !== folder)
    await ask(worldOf(hands), { do: "folder", name: parentOf(name), mask: null });
  if (screen.get().face === "full") {
    return screen.open({ kind: "command", letters: "FP", given: [baseOf({ name })] });
  }
  if (await ask(worldOf(hands), { do: "open", name })) screen.open(null);
}

/** The word for what a file is opened as. */
export const kindWord = ({ folder, opens }: FileInfo): string => {
  if (folder) return "";
  switch (opens) {
    case "program":
      return "program";
    case "job":
      return "job";
    case "drawing":
      return "drawing";
    default:
      return "text";
  }
};
