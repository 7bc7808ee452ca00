/** The file in the editor: which, what was read, what became of it. */

import { ChangeSet, Text } from "@codemirror/state";
import type { TextDraft, TextEdit } from "../wire/messages";
import type { Content } from "./readText";
import type { LineEnd } from "./storedText";
import { takingTurns } from "./turns";

export interface EditedFile {
  /** Name below the part folder; a new file has none. */
  readonly name: string | null;
  /** The text as it was read or saved. */
  readonly kept: Text;
  readonly text: Text;
  /** The changes that made the text of the kept one. */
  readonly typed: ChangeSet;
  /** Those of them since it was last given to be saved. */
  readonly since: ChangeSet;
  /** Line end of the file; in here it is a line feed. */
  readonly ends: LineEnd;
  /** The hash of the file as it was read or saved; a new one has none. */
  readonly hash: string;
}

/** Longest text that is kept and checked as a whole while somebody types, characters. */
export const longest = 700_000;

/** A text is written in pieces of so many characters. */
const piece = 1 << 18;

const unchanged = ({ length }: Text): ChangeSet => ChangeSet.empty(length);

const untouched = (text: Text) => ({
  kept: text,
  text,
  typed: unchanged(text),
  since: unchanged(text),
});

export const newFile: EditedFile = { name: null, ...untouched(Text.empty), ends: "\n", hash: "" };

export const isChanged = ({ kept, text }: EditedFile): boolean => !kept.eq(text);

export const opened = (name: string, { text, ends, hash }: Content): EditedFile => ({
  name,
  ...untouched(text),
  ends,
  hash,
});

/** A file with the text that was typed into it and not saved; it is as the file was then. */
export function drafted(file: EditedFile, draft: TextDraft): EditedFile {
  const changes = draft.edits ? changesOf(file.kept, draft.edits) : replaced(file.kept, draft.text);
  const back = edited(file, changes.apply(file.kept), changes);
  return { ...back, ends: draft.ends as LineEnd, hash: draft.base };
}

/** A text in the place of another one. */
const replaced = ({ length }: Text, text: string): ChangeSet =>
  ChangeSet.of({ from: 0, to: length, insert: Text.of(text.split("\n")) }, length);

/** The changes that edits make of a text. */
const changesOf = (base: Text, edits: readonly TextEdit[]): ChangeSet =>
  ChangeSet.of(
    edits.map(({ line, count, lines }) => ({
      from: base.line(line).from,
      to: base.line(line + count - 1).to,
      insert: Text.of(lines),
    })),
    base.length,
  );

/** Lines of the kept text, and those that stand in their place. */
interface ChangedLines {
  readonly kept: number;
  keptTo: number;
  readonly now: number;
  nowTo: number;
}

/** The typed changes, by lines. */
function editsOf({ kept, text, typed }: EditedFile): TextEdit[] {
  const all: ChangedLines[] = [];
  typed.iterChangedRanges((keptFrom, keptTo, from, to) => {
    const next = {
      kept: kept.lineAt(keptFrom).number,
      keptTo: kept.lineAt(keptTo).number,
      now: text.lineAt(from).number,
      nowTo: text.lineAt(to).number,
    };
    const last = all.at(-1);
    if (last && next.kept <= last.keptTo)
      Object.assign(last, { keptTo: next.keptTo, nowTo: next.nowTo });
    else all.push(next);
  });
  return all.map((one) => ({
    line: one.kept,
    count: one.keptTo - one.kept + 1,
    lines: text.slice(text.line(one.now).from, text.line(one.nowTo).to).toJSON(),
  }));
}

/** Its text, as the server keeps it until it is saved: of a long one what was typed into it. */
export function draftOf(file: EditedFile): TextDraft {
  const { name, text, ends, hash } = file;
  const isLong = text.length > longest;
  return {
    name: name ?? "",
    text: isLong ? "" : text.toString(),
    edits: isLong ? editsOf(file) : null,
    ends,
    base: hash,
    changedOnDisk: false,
    page: "",
    revision: "",
  };
}

/** As it is written: its lines end as they did. */
export async function written({ text, ends }: EditedFile): Promise<Blob> {
  const [turn, pieces] = [takingTurns(), [] as Blob[]];
  for (let from = 0; from < text.length; from += piece) {
    pieces.push(new Blob([text.sliceString(from, from + piece, ends)]));
    await turn();
  }
  return new Blob(pieces);
}

/** The file after these changes, which made this text of it. */
export const edited = (file: EditedFile, text: Text, changes: ChangeSet): EditedFile => ({
  ...file,
  text,
  typed: file.typed.compose(changes),
  since: file.since.compose(changes),
});

/** The file, whose text is given to be saved. */
export const saving = (file: EditedFile): EditedFile => ({ ...file, since: unchanged(file.text) });

/** The file, of which this text was written under a name; more may have been typed since it was given to be saved. */
export const saved = (
  file: EditedFile,
  { name, text, hash }: { name: string; text: Text; hash: string },
): EditedFile => ({ ...file, name, kept: text, typed: file.since, hash });

/** A name with the ending of a part file when it has none. */
export const withEnding = (name: string): string => (/\.\w+$/.test(name) ? name : `${name}.sbp`);
