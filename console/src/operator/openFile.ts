/** Opens a file of the part folder as what it is. */

import { ask } from "../actions/ask";
import { type Hands, worldOf } from "../app/context";
import { asNamed } from "../command/lastFile";
import type { FileInfo } from "../wire/messages";
import { t } from "../words/words";
import { baseOf, parentOf } from "./folder";

/** Opens a drawing on its own screen; the one on the sheet goes. */
export async function openDrawing(hands: Hands, name: string): Promise<void> {
  const { screen } = hands;
  const { sheet } = screen.get();
  if (!(await ask(worldOf(hands), { do: "draw", op: { op: "open", name } }))) return;
  screen.close(sheet);
  screen.go("/draw");
}

/** Opens a program or a job to be run: with the sheet of FP where there are command keys. */
export async function openToRun(hands: Hands, name: string, folder: string): Promise<void> {
  const { screen } = hands;
  const { sheet } = screen.get();
  const named = screen.get().face === "full" ? await namedForFp(hands, name, folder) : "";
  if (named) return screen.open({ kind: "command", letters: "FP", given: [named] });
  if (await ask(worldOf(hands), { do: "open", name })) screen.close(sheet);
}

/** A file as FP names it; nothing where FP does not find it. The owner's choice of a file chooses its folder too (FS). */
async function namedForFp(hands: Hands, name: string, folder: string): Promise<string> {
  const world = worldOf(hands);
  if (parentOf(name) === folder || world.shown.who?.role !== "owner") return asNamed(folder, name);
  const chosen = await ask(world, { do: "folder", name: parentOf(name), mask: null });
  return chosen ? baseOf({ name }) : "";
}

/** The word for what a file is opened as. */
export const kindWord = ({ folder, opens }: FileInfo): string => {
  if (folder) return "";
  switch (opens) {
    case "program":
      return t("program");
    case "job":
      return t("job");
    case "drawing":
      return t("drawing");
    default:
      return t("text");
  }
};
