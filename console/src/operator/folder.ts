/** What the file picker shows: one folder, by a mask. */

import type { FileInfo } from "../wire/messages";

export const parentOf = (folder: string): string => folder.split("/").slice(0, -1).join("/");

/** Whether a name matches a mask as the file commands have it: `*.sbp`, `a?.nc`, or part of a name. */
export function matches(name: string, mask: string): boolean {
  const wanted = mask.trim().toLowerCase();
  if (!/[*?]/.test(wanted)) return name.toLowerCase().includes(wanted);
  const pattern = wanted
    .replace(/[.+^${}()|[\]\\]/g, "\\$&")
    .replaceAll("*", ".*")
    .replaceAll("?", ".");
  return new RegExp(`^${pattern}$`).test(name.toLowerCase());
}

/** Folders first, then files, each by name. */
export function inFolder(files: readonly FileInfo[], folder: string, mask: string): FileInfo[] {
  return files
    .filter(({ name }) => parentOf(name) === folder)
    .filter(({ name, folder: isFolder }) => isFolder || matches(name.split("/").at(-1) ?? "", mask))
    .sort((a, b) => Number(b.folder) - Number(a.folder) || a.name.localeCompare(b.name));
}
