import { describe, expect, it } from "vitest";
import { changedLines, linesOf, notAVariable } from "./variableLines";

describe("the list of variables as text", () => {
  it("has a line each, text in quotes", () =>
    expect(
      linesOf([
        { name: "&A", value: "-2.5" },
        { name: "&B", value: "two words" },
      ]),
    ).toBe('&A = -2.5\n&B = "two words"'));

  it("is carried out as far as it was changed", () =>
    expect(changedLines("&A = 2\n&B = 1", "&A = 3\n&B = 1\n\n &C = 4 ")).toBe("&A = 3\n&C = 4"));

  it("sets variables and nothing else", () => {
    expect(notAVariable("&A = 2\n$kept := 1\n")).toBeUndefined();
    expect(notAVariable("&A = 2\nMX,1")).toBe("MX,1");
  });
});
