/** Copies, renames and deletes files of the part folder. */

import { copyFile, deleteFile } from "../link/http";
import { answersOf } from "../operator/folder";
import type { FileAbout } from "../wire/messages";
import type { World } from "./action";
import { ask } from "./ask";
import { aboutFile, isThere, writing } from "./replace";

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
async function copiedAlone(world: World, name: string, to: string): Promise<boolean> {
  let isWritten = false;
  await told(world, async () => {
    isWritten = await writing(world, to, (replaces) => copyFile(name, to, replaces));
  });
  return isWritten;
}

/** Does the same with the sample answers beside a file, where it has any. */
async function withAnswers(
  world: World,
  name: string,
  does: (answers: string) => Promise<unknown>,
): Promise<void> {
  const answers = answersOf(name);
  await told(world, async () => void ((await isThere(answers)) && (await does(answers))));
}

/** Copies a file, with the sample answers beside it. Tells whether it was written. */
export async function copied(world: World, name: string, to: string): Promise<boolean> {
  if (!(await copiedAlone(world, name, to))) return false;
  await withAnswers(world, name, (answers) => copiedAlone(world, answers, answersOf(to)));
  return true;
}

/**
 * Moves a file into the bin, as it was when the person was asked, with the sample answers beside it; its history goes to
 * the name that it has now, where it was renamed.
 */
export async function deleted(
  world: World,
  { name, hash }: FileAbout,
  renamed?: string,
): Promise<boolean> {
  // It is closed where it was open.
  const isOpen = world.shown.snapshot?.opened?.name === name;
  if (isOpen && !(await ask(world, { do: "close" }))) return false;
  if (!(await told(world, () => deleteFile(name, hash, renamed)))) return false;
  await withAnswers(world, name, async (answers) =>
    deleteFile(answers, (await aboutFile(answers)).hash),
  );
  return true;
}

/** Gives a file another name; it is open under that where it was open. Tells whether it has the name. */
export async function renamed(world: World, name: string, to: string): Promise<boolean> {
  if (to === name) return true;
  const isOpen = world.shown.snapshot?.opened?.name === name;
  const about = await aboutFile(name);
  if (!(await copied(world, name, to)) || !(await deleted(world, about, to))) return false;
  return !isOpen || ask(world, { do: "open", name: to });
}
