import { ChangeSet, Text } from "@codemirror/state";
import { expect, it } from "vitest";
import type { Finding } from "../wire/messages";
import {
  type CheckedPiece,
  changedPieces,
  findingsOf,
  linesOf,
  nextPiece,
  type Pieces,
  piecesOf,
  shareOf,
  withFindings,
} from "./checkedPieces";

const lines = Array.from({ length: 60_000 }, (_, n) => `M3,${n},1,1`);
const text = Text.of(lines);

const wrongAt = (line: number): Finding[] => [
  { level: "error", code: "E001", file: "", line, column: 1, length: 0, message: "", hint: "" },
];

/** Every piece looked at, with what is found where a line begins with "FOO". */
function looked(pieces: Pieces, of: Text): Pieces {
  for (let next = nextPiece(pieces, 0); next; next = nextPiece(pieces, 0)) {
    const own = linesOf(pieces, next, of).split("\n");
    const found = own.flatMap((line, n) => (line.startsWith("FOO") ? wrongAt(n + 1) : []));
    pieces = withFindings(pieces, next, found);
  }
  return pieces;
}

/** The text that all pieces have together. */
const together = (pieces: Pieces, of: Text) =>
  pieces.map((piece) => linesOf(pieces, piece, of)).join("\n");

it("pieces are whole lines, and all of them the text", () => {
  const pieces = piecesOf(text);
  expect(pieces.length).toBeGreaterThan(2);
  expect(together(pieces, text) === text.toString()).toBe(true);
  expect(shareOf(pieces)).toBe(0);
  expect(shareOf(looked(pieces, text))).toBe(1);
});

it("the piece at the cursor comes first", () => {
  const pieces = piecesOf(text);
  expect(nextPiece(pieces, text.length)).toBe(pieces.at(-1));
  expect(nextPiece(pieces, 0)).toBe(pieces[0]);
});

it.each([
  ["a sign", 400_000, 400_000, "x"],
  ["a line", text.line(50_000).from, text.line(50_000).from, "FOO,1\n"],
  ["a line less", text.line(50_000).from, text.line(50_001).from, ""],
  ["the ends of lines gone", 300_000, 300_100, ""],
  ["much", 100, 101, "MX,1\n".repeat(300_000)],
  ["all gone", 0, text.length, ""],
  ["the end gone", text.length - 1000, text.length, ""],
])("%s typed makes few pieces new", (_, from, to, insert) => {
  const pieces = looked(piecesOf(text), text);
  const changes = ChangeSet.of({ from, to, insert: Text.of(insert.split("\n")) }, text.length);
  const now = changes.apply(text);
  const after = changedPieces(pieces, changes, now);
  expect(together(after, now) === now.toString()).toBe(true);
  const isNew = after.filter(({ findings }) => findings === null).length;
  expect(isNew).toBeGreaterThan(0);
  if (insert.length < 1000 && to - from < 1000) expect(isNew).toBeLessThanOrEqual(2);
  const wrong = findingsOf(looked(after, now), now).map(({ line }) => now.line(line).text);
  expect(wrong).toEqual(insert.startsWith("FOO") ? ["FOO,1"] : []);
});

it("where a piece ends, what is typed belongs to one", () => {
  const pieces = looked(piecesOf(text), text);
  const end = pieces[0]?.length ?? 0;
  for (const [from, to] of [
    [end - 1, end],
    [end, end + 1],
    [end, end],
  ] as const) {
    const changes = ChangeSet.of({ from, to, insert: "x" }, text.length);
    const now = changes.apply(text);
    const after = changedPieces(pieces, changes, now);
    expect(together(after, now) === now.toString()).toBe(true);
  }
});

it("findings of a long text look only for the lines at which something is told", () => {
  let sought = 0;
  const text = {
    length: 4_000_000,
    lineAt: () => {
      sought += 1;
      return { number: 7 };
    },
  } as unknown as Text;
  const piece = { length: 10_000, findings: [] };
  const pieces: Pieces = [
    ...Array<CheckedPiece>(300).fill(piece),
    { ...piece, findings: wrongAt(3) },
    ...Array<CheckedPiece>(99).fill({ ...piece, findings: null }),
  ];
  expect(findingsOf(pieces, text).map(({ line }) => line)).toEqual([9]);
  expect(sought).toBe(1);
});
