/** The file in the editor: which, what was read, what became of it. */

export interface EditedFile {
  /** Name below the part folder; a new file has none. */
  readonly name: string | null;
  /** What the file holds on disk. */
  readonly kept: string;
  readonly text: string;
  /** What ends its lines; in here it is a line feed. */
  readonly ends: LineEnd;
}

export type LineEnd = "\n" | "\r\n" | "\r";

export const newFile: EditedFile = { name: null, kept: "", text: "", ends: "\n" };

export const isChanged = ({ kept, text }: EditedFile): boolean => kept !== text;

/** What ends the first line, as the machines of its maker end lines. */
const endsOf = (text: string): LineEnd => (/\r\n|\r|\n/.exec(text)?.[0] as LineEnd) ?? "\n";

export function opened(name: string, read: string): EditedFile {
  const text = read.replace(/\r\n|\r/g, "\n");
  return { name, kept: text, text, ends: endsOf(read) };
}

/** As it is written: its lines end as they did. */
export const written = ({ text, ends }: EditedFile): string => text.replaceAll("\n", ends);

export const edited = (file: EditedFile, text: string): EditedFile => ({ ...file, text });

export const saved = (file: EditedFile, name: string): EditedFile => ({
  ...file,
  name,
  kept: file.text,
});

/** A name with the ending of a part file when it has none. */
export const withEnding = (name: string): string => (/\.\w+$/.test(name) ? name : `${name}.sbp`);
