import { ChangeSet, Text } from "@codemirror/state";
import { expect, it } from "vitest";
import { folded, textOf } from "./storedText";

const read = (text: string) => folded(new TextEncoder().encode(text));

const plain = (text: string) => Text.of(text.split(/\r\n|\r|\n/));

const numbered = (count: number, line: (n: number) => string) =>
  Array.from({ length: count }, (_, n) => line(n)).join("\n");

const texts: [string, string][] = [
  ["nothing", ""],
  ["a line", "MX,1"],
  ["a line that ends", "MX,1\n"],
  ["511 lines", numbered(511, (n) => `MX,${n}`)],
  ["512 lines that end", `${numbered(512, (n) => `MX,${n}`)}\n`],
  ["513 lines", numbered(513, (n) => `MX,${n}`)],
  ["5000 lines", numbered(5000, (n) => `M3,${n},${n / 7}`)],
  ["empty lines", "\n".repeat(100)],
  ["signs of many bytes", numbered(200, (n) => `' Größe ${n} 𝄞 in µm`)],
  ["lines of an old machine", "MX,1\rMX,2\r"],
  ["lines of two sorts", "MX,1\r\nMX,2\n\r\nMX,3\r\r\n"],
];

it.each(texts)("%s is the text that it would be without bytes", (_, text) => {
  const [stored, expected] = [textOf(read(text)), plain(text)];
  expect(stored.toString()).toBe(expected.toString());
  expect([stored.lines, stored.length]).toEqual([expected.lines, expected.length]);
  for (const n of [1, 17, 512, 513, expected.lines].filter((n) => n <= expected.lines))
    expect(stored.line(n)).toMatchObject({ ...expected.line(n) });
  const places = [0, 1, 5, 100, 4000, expected.length - 1, expected.length];
  for (const at of places.filter((at) => at >= 0 && at <= expected.length)) {
    expect(stored.lineAt(at)).toMatchObject({ ...expected.lineAt(at) });
    expect(stored.sliceString(at, at + 3000)).toBe(expected.sliceString(at, at + 3000));
    expect(stored.sliceString(at, at + 99, "\r\n")).toBe(expected.sliceString(at, at + 99, "\r\n"));
  }
});

it("is edited as another text", () => {
  const text = numbered(1000, (n) => `M3,${n}`);
  let [stored, expected] = [textOf(read(text)), plain(text)];
  const first = stored;
  for (const [from, to, insert] of [
    [0, 0, "' first\n"],
    [3000, 4000, ""],
    [777, 778, "é\né"],
    [5, 6, ""],
  ] as const) {
    const changes = ChangeSet.of({ from, to, insert }, stored.length);
    [stored, expected] = [changes.apply(stored), changes.apply(expected)];
    expect(stored.toString()).toBe(expected.toString());
    expect(stored.eq(expected) && expected.eq(stored)).toBe(true);
    expect(stored.eq(first)).toBe(false);
  }
  expect(first.toString()).toBe(text);
});

it.each([
  ["a\r\nb\n", "\r\n"],
  ["a\nb\r\n", "\n"],
  ["a\rb", "\r"],
  ["a", "\n"],
])("%j ends its lines with %j", (text, ends) => expect(read(text).ends).toBe(ends));

it("passes over the mark of UTF-8", () => {
  expect(textOf(read("\uFEFFMX,1")).toString()).toBe("MX,1");
});
