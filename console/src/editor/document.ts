/** The file in the editor: which, what was read, what became of it. */

import type { Content } from "../link/http";
import type { TextDraft } from "../wire/messages";

export interface EditedFile {
  /** Name below the part folder; a new file has none. */
  readonly name: string | null;
  /** What the file holds on disk. */
  readonly kept: string;
  readonly text: string;
  /** What ends its lines; in here it is a line feed. */
  readonly ends: LineEnd;
  /** The hash of the file as it was read or saved; a new one has none. */
  readonly hash: string;
}

export type LineEnd = "\n" | "\r\n" | "\r";

export const newFile: EditedFile = { name: null, kept: "", text: "", ends: "\n", hash: "" };

export const isChanged = ({ kept, text }: EditedFile): boolean => kept !== text;

/** What ends the first line, as the machines of its maker end lines. */
const endsOf = (text: string): LineEnd => (/\r\n|\r|\n/.exec(text)?.[0] as LineEnd) ?? "\n";

export function opened(name: string, read: Content): EditedFile {
  const text = read.text.replace(/\r\n|\r/g, "\n");
  return { name, kept: text, text, ends: endsOf(read.text), hash: read.hash };
}

/** A file with the text that was typed into it and not saved. */
export const drafted = (file: EditedFile, draft: TextDraft): EditedFile => ({
  ...file,
  text: draft.text,
  ends: draft.ends as LineEnd,
  hash: draft.base,
});

/** Its text, as the server keeps it until it is saved. */
export const draftOf = ({ name, text, ends, hash }: EditedFile): TextDraft => ({
  name: name ?? "",
  text,
  ends,
  base: hash,
  changedOnDisk: false,
  page: "",
  revision: "",
});

/** As it is written: its lines end as they did. */
export const written = ({ text, ends }: EditedFile): string => text.replaceAll("\n", ends);

export const edited = (file: EditedFile, text: string): EditedFile => ({ ...file, text });

/** The file, of which this text was written under a name; more may have been typed since. */
export const saved = (
  file: EditedFile,
  { name, text, hash }: { name: string; text: string; hash: string },
): EditedFile => ({ ...file, name, kept: text, hash });

/** A name with the ending of a part file when it has none. */
export const withEnding = (name: string): string => (/\.\w+$/.test(name) ? name : `${name}.sbp`);
