/** What the file picker shows: one folder, by a mask. */

import type { FileInfo } from "../wire/messages";

/** A file's name without its folders. */
export const baseOf = ({ name }: Pick<FileInfo, "name">): string => name.split("/").at(-1) ?? name;

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

/** Folders first, then files, each by name: part files where no mask asks for others. */
export function inFolder(files: readonly FileInfo[], folder: string, mask: string): FileInfo[] {
  return files
    .filter(({ name }) => parentOf(name) === folder)
    .filter((file) => file.folder || (mask.trim() === "" ? file.part : matches(baseOf(file), mask)))
    .sort((a, b) => Number(b.folder) - Number(a.folder) || a.name.localeCompare(b.name));
}
