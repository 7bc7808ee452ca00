/** The part file that FP and FG mean where nobody names one. */

import type { World } from "../actions/action";
import { getJson } from "../link/http";
import type { Values } from "../wire/messages";

/** Commands that run a part file. */
export const runsFile = (letters: string): boolean => letters === "FP" || letters === "FG";

/** A file as FP names it: below the folder that part files are chosen from; nothing where it lies elsewhere. */
export function asNamed(folder: string, name: string): string {
  if (folder === "") return name;
  return name.startsWith(`${folder}/`) ? name.slice(folder.length + 1) : "";
}

/** The file that is open, else the one that ran last, as FP names it; nothing where there is none. */
export async function lastFile({ shown }: World): Promise<string> {
  const { opened, folder } = shown.snapshot ?? {};
  const open = asNamed(folder?.name ?? "", opened?.name ?? "");
  if (open) return open;
  const { partFile } = await getJson<Values>("/api/values");
  return asNamed(folder?.name ?? "", partFile ?? "");
}
