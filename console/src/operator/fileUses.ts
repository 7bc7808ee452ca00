/** Uses of a file of the part folder that is chosen. */

export type FileUse = "open" | "download" | "copy" | "rename" | "delete" | "versions";

export const fileUses: readonly { readonly value: FileUse; readonly words: string }[] = [
  { value: "open", words: "Open" },
  { value: "download", words: "Download" },
  { value: "copy", words: "Copy…" },
  { value: "rename", words: "Rename…" },
  { value: "delete", words: "Delete…" },
  { value: "versions", words: "Versions…" },
];

/** A name beside another one: `doors/a copy.sbp`. */
export const copyName = (name: string): string => name.replace(/(\.[^./]*)?$/, " copy$1");
