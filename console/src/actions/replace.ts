/** Writes files, and asks before one is replaced. */

import { fileAddress, getJson } from "../link/http";
import { baseOf, parentOf } from "../operator/folder";
import type { FileAbout, FileInfo, Problem } from "../wire/messages";
import type { World } from "./action";

/** Tries to write; the hash names the file that may be replaced. Gives why nothing was written. */
export type Attempt = (replaces: string | null) => Promise<Problem | null>;

/** Asks whether the file may be replaced that is there. */
export type Question = (about: FileAbout) => Promise<boolean>;

/** End of writing: the file is written, the one that was there is left as it was, or the reason of a refusal. */
export type Written = "written" | "left" | Problem;

/**
 * Writes under a name. Where another file would be replaced, the person is asked first, and once more
 * when that one is changed meanwhile.
 */
export async function written(name: string, attempt: Attempt, asks: Question): Promise<Written> {
  let replaces: string | null = null;
  for (;;) {
    const problem = await attempt(replaces);
    if (!problem) return "written";
    if (problem.why !== "replaces") return problem;
    const about = await aboutFile(name);
    if (!(await asks(about))) return "left";
    replaces = about.hash;
  }
}

/** Writes under a name, as {@link written}, with the question over the screen. Tells whether it was written. */
export async function writing(world: World, name: string, attempt: Attempt): Promise<boolean> {
  const end = await written(name, attempt, (about) => asked(world, about));
  if (typeof end === "object") world.screen.tell(end.text);
  return end === "written";
}

/** Asks the person if the file under a name may be replaced. */
export const mayReplace = async (world: World, name: string): Promise<boolean> =>
  asked(world, await aboutFile(name));

/** The file that lies under a name. */
export const aboutFile = (name: string): Promise<FileAbout> =>
  getJson<FileAbout>(`${fileAddress(name)}?about`);

/** Looks for a file under a name; nothing where none lies there. */
export async function fileNamed(name: string): Promise<FileInfo | undefined> {
  const query = new URLSearchParams({ folder: parentOf(name), mask: baseOf({ name }) });
  const there = await getJson<FileInfo[]>(`/api/files?${query}`);
  return there.find((file) => file.name === name && !file.folder);
}

/** Looks for a file under a name: true where one lies there. */
export const isThere = async (name: string): Promise<boolean> =>
  (await fileNamed(name)) !== undefined;

/** Asks; another sheet in the way is no leave. */
function asked({ screen }: World, about: FileAbout): Promise<boolean> {
  return new Promise((answer) => {
    const sheet = { kind: "replace", about, answer } as const;
    screen.open(sheet);
    const unwatch = screen.watch(() => {
      if (screen.get().sheet === sheet) return;
      unwatch();
      answer(false);
    });
  });
}
