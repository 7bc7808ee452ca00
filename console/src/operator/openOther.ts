/** Opens a file that is no program, no job and no drawing: a picture is converted, settings are loaded, text is edited. */

import type { Hands } from "../app/context";
import { asNamed } from "../command/lastFile";
import { readFile } from "../link/http";
import { isOfSettings } from "../settings/settingsFile";
import type { FileInfo } from "../wire/messages";

/** Pictures whose brightness becomes heights (FC). */
const isPicture = (name: string): boolean => /\.(?:bmp|jpe?g|png)$/i.test(name);

/** A file of settings is no longer, bytes. */
const longestSettings = 1_000_000;

async function settingsIn({ name, bytes }: FileInfo): Promise<string | undefined> {
  if (!/\.txt$/i.test(name) || bytes > longestSettings) return undefined;
  const { text } = await readFile(name);
  return isOfSettings(text) ? text : undefined;
}

/** Opens a file of the part folder, which stands in `folder` where FC looks for names without one. */
export async function openOther(hands: Hands, file: FileInfo, folder: string): Promise<void> {
  const { screen } = hands;
  if (isPicture(file.name)) {
    const given = [asNamed(folder, file.name)];
    return screen.open({ kind: "command", letters: "FC", given });
  }
  const text = await settingsIn(file);
  if (text === undefined) screen.edit(file.name);
  else screen.open({ kind: "loadSettings", text });
}
