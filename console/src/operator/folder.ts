/** The list of the file picker: one folder, or the files found in all of them. */

import type { FileInfo } from "../wire/messages";

/** A file's name without its folders. */
export const baseOf = ({ name }: Pick<FileInfo, "name">): string => name.split("/").at(-1) ?? name;

export const parentOf = (folder: string): string => folder.split("/").slice(0, -1).join("/");

/** The file of sample answers beside a program. */
export const answersOf = (file: string): string => `${file}.answers`;

/** Tells whether a name matches a mask as the file commands have it: `*.sbp`, `a?.nc`, or part of a name. */
export function matches(name: string, mask: string): boolean {
  const wanted = mask.trim().toLowerCase();
  if (!/[*?]/.test(wanted)) return name.toLowerCase().includes(wanted);
  const pattern = wanted
    .replace(/[.+^${}()|[\]\\]/g, "\\$&")
    .replaceAll("*", ".*")
    .replaceAll("?", ".");
  return new RegExp(`^${pattern}$`).test(name.toLowerCase());
}

/** Folders first, then files, each by name: what can be opened, unless a mask as `*.log` asks for others. */
export function listed(files: readonly FileInfo[], word: string): FileInfo[] {
  const all = /[*?]/.test(word);
  return files
    .filter((file) => file.folder || all || file.opens !== null)
    .filter((file) => word === "" || (!file.folder && matches(baseOf(file), word)))
    .sort((a, b) => Number(b.folder) - Number(a.folder) || a.name.localeCompare(b.name));
}
