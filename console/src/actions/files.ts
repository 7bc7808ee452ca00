/** Copies, renames and deletes files of the part folder. */

import { copyFile, deleteFile, getJson } from "../link/http";
import { baseOf, parentOf } from "../operator/folder";
import { answersOf } from "../tools/samples";
import type { FileAbout, FileInfo } from "../wire/messages";
import type { World } from "./action";
import { ask } from "./ask";
import { aboutFile, writing } from "./replace";

/** Does what may be refused, and tells the refusal. */
async function told(world: World, does: () => Promise<void>): Promise<boolean> {
  try {
    await does();
    return true;
  } catch (error) {
    world.screen.tell((error as Error).message);
    return false;
  }
}

/** Writes a copy under another name; asks first where a file lies there. Tells whether it was written. */
export async function copied(world: World, name: string, to: string): Promise<boolean> {
  let isWritten = false;
  await told(world, async () => {
    isWritten = await writing(world, to, (replaces) => copyFile(name, to, replaces));
  });
  return isWritten;
}

/** Moves a file into the bin, as it was when the person was asked; it is closed where it was open. */
export async function deleted(world: World, { name, hash }: FileAbout): Promise<boolean> {
  const isOpen = world.shown.snapshot?.opened?.name === name;
  if (isOpen && !(await ask(world, { do: "close" }))) return false;
  return told(world, () => deleteFile(name, hash));
}

/**
 * Gives a file another name, and the sample answers beside it too; it is open under that where it was open. Tells whether
 * it has the name.
 */
export async function renamed(world: World, name: string, to: string): Promise<boolean> {
  if (to === name) return true;
  const isOpen = world.shown.snapshot?.opened?.name === name;
  const answers = await answersBeside(name);
  if (!(await moved(world, name, to))) return false;
  if (answers && !(await moved(world, answers, answersOf(to)))) return false;
  return !isOpen || ask(world, { do: "open", name: to });
}

/** Writes a file under another name and takes it away under its own. */
async function moved(world: World, name: string, to: string): Promise<boolean> {
  const about = await aboutFile(name);
  return (await copied(world, name, to)) && deleted(world, about);
}

/** The name of the sample answers that stand beside a file, where there are some. */
export async function answersBeside(name: string): Promise<string | undefined> {
  const beside = answersOf(name);
  const query = new URLSearchParams({ folder: parentOf(beside), mask: baseOf({ name: beside }) });
  const files = await getJson<FileInfo[]>(`/api/files?${query}`);
  return files.find((file) => file.name === beside)?.name;
}
