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
  ["1023 lines", numbered(1023, (n) => `MX,${n}`)],
  ["1024 lines that end", `${numbered(1024, (n) => `MX,${n}`)}\n`],
  ["1025 lines", numbered(1025, (n) => `MX,${n}`)],
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
  for (const n of [1, 17, 1024, 1025, expected.lines].filter((n) => n <= expected.lines))
    expect(stored.line(n)).toMatchObject({ ...expected.line(n) });
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
