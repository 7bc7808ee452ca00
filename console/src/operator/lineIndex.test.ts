import { describe, expect, it } from "vitest";
import { indexLines, lineAt, lineCount } from "./lineIndex";

const index = (text: string) => indexLines(new TextEncoder().encode(text));

describe("the lines of a text", () => {
  it.each<[string, string[]]>([
    ["a\nb\nc", ["a", "b", "c"]],
    ["a\r\nb\r\n", ["a", "b"]],
    ["", [""]],
    ["\n\nx\n", ["", "", "x"]],
    ["½ inch\nnext", ["½ inch", "next"]],
  ])("%j", async (text, lines) => {
    const found = await index(text);
    expect(lineCount(found)).toBe(lines.length);
    expect(lines.map((_, n) => lineAt(found, n + 1))).toEqual(lines);
  });

  it("has nothing beyond its end", async () => {
    const found = await index("a\nb");
    expect([lineAt(found, 0), lineAt(found, 3)]).toEqual(["", ""]);
  });

  it("finds a hundred thousand lines", async () => {
    const found = await index("M2,1,2\n".repeat(100_000));
    expect(lineCount(found)).toBe(100_000);
    expect(lineAt(found, 100_000)).toBe("M2,1,2");
  });
});
