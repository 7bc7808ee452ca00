import { ChangeSet, Text } from "@codemirror/state";
import { expect, it } from "vitest";
import {
  drafted,
  draftOf,
  type EditedFile,
  edited,
  isChanged,
  opened,
  saved,
  saving,
} from "./document";

const lines = Array.from({ length: 80_000 }, (_, n) => `M3,${n},1,1`);

const long = (): EditedFile =>
  opened("long.sbp", { text: Text.of(lines), ends: "\r\n", hash: "1" });

function typed(file: EditedFile, from: number, to: number, insert: string): EditedFile {
  const changes = ChangeSet.of({ from, to, insert: Text.of(insert.split("\n")) }, file.text.length);
  return edited(file, changes.apply(file.text), changes);
}

const lineAt = ({ text }: EditedFile, n: number): number => text.line(n).from;

it.each<[string, (file: EditedFile) => EditedFile, number]>([
  ["a sign", (file) => typed(file, lineAt(file, 500) + 2, lineAt(file, 500) + 2, "x"), 1],
  [
    "lines at both ends",
    (file) => typed(typed(file, 0, 0, "' a\n"), file.text.length, file.text.length, "\nMX,1"),
    2,
  ],
  ["a line less", (file) => typed(file, lineAt(file, 9), lineAt(file, 10), ""), 1],
  ["twice in a line", (file) => typed(typed(file, 0, 1, "J"), 3, 3, "7"), 1],
  [
    "lines of which one is typed into again",
    (file) => typed(typed(file, 5, 5, "\n\n"), 6, 6, "MX"),
    1,
  ],
])("of a long text a draft is what was typed: %s", (_, type, count) => {
  const file = type(long());
  const draft = draftOf(file);
  expect([draft.text, draft.edits?.length]).toEqual(["", count]);
  expect(JSON.stringify(draft).length).toBeLessThan(500);
  const back = drafted(long(), draft);
  expect(back.text.eq(file.text)).toBe(true);
  expect(draftOf(back)).toEqual(draft);
});

it("of a short text a draft is the text", () => {
  const file = opened("a.sbp", { text: Text.of(["MX,1"]), ends: "\n", hash: "1" });
  const draft = draftOf(typed(file, 4, 4, "2"));
  expect([draft.text, draft.edits]).toEqual(["MX,12", null]);
  expect(drafted(file, draft).text.toString()).toBe("MX,12");
});

it("what is typed while it is saved is left to be saved", () => {
  const given = saving(typed(long(), 0, 0, "' a\n"));
  const later = typed(given, 1, 1, "b");
  const done = saved(later, { name: "long.sbp", text: given.text, hash: "2" });
  expect(isChanged(done)).toBe(true);
  expect(draftOf(done)).toMatchObject({
    base: "2",
    edits: [{ line: 1, count: 1, lines: ["'b a"] }],
  });
  expect(isChanged(saved(given, { name: "long.sbp", text: given.text, hash: "2" }))).toBe(false);
});
