/** The file in the editor: which, what was read, what became of it. */

export interface EditedFile {
  /** Name below the part folder; a new file has none. */
  readonly name: string | null;
  /** What the file holds on disk. */
  readonly kept: string;
  readonly text: string;
}

export const newFile: EditedFile = { name: null, kept: "", text: "" };

export const isChanged = ({ kept, text }: EditedFile): boolean => kept !== text;

export const opened = (name: string, text: string): EditedFile => ({ name, kept: text, text });

export const edited = (file: EditedFile, text: string): EditedFile => ({ ...file, text });

export const saved = (file: EditedFile, name: string): EditedFile => ({
  ...file,
  name,
  kept: file.text,
});

/** A name with the ending of a part file when it has none. */
export const withEnding = (name: string): string => (/\.\w+$/.test(name) ? name : `${name}.sbp`);
