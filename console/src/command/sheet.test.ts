import { describe, expect, it } from "vitest";
import { entry, parameter } from "./fixtures";
import { firstEntries, lineOf, mistakesIn, parted, resetEntries, withEntry } from "./sheet";

const circle = entry(
  "CC",
  [
    parameter("diameter", { required: true }),
    parameter("side", { kind: { is: "choice", words: ["T", "O", "I"] }, default: "T" }),
    parameter("overlap", { least: 0, most: 99, default: "10" }),
    parameter("plunge", { default: "-0.00" }),
  ],
  "cut",
);

describe("a fill-in sheet", () => {
  it("writes what has to be given, even where it is what holds already", () => {
    const one = entry("SF", [parameter("check", { required: true, present: "1" })]);
    expect(lineOf(one, ["1"])).toBe("SF,1");
  });

  it("takes what is typed on behind the letters of its command", () => {
    expect(parted(",", true)).toEqual({ kept: "", goesOn: false });
    expect(parted(", part.sbp", true)).toEqual({ kept: "part.sbp", goesOn: false });
    expect(parted("part.sbp,", true)).toEqual({ kept: "part.sbp", goesOn: true });
    expect(parted("2,", false)).toEqual({ kept: "2", goesOn: true });
    expect(parted('"a,', false)).toEqual({ kept: '"a,', goesOn: false });
  });

  it("opens with what was typed so far and what is usual", () =>
    expect(firstEntries(circle, ["4", "", "20"])).toEqual(["4", "T", "20", "-0.00"]));

  it("shows present settings", () => {
    const ms = entry("MS", [parameter("XY", { present: "1.5" })]);
    expect(resetEntries(ms)).toEqual(["1.5"]);
    expect(lineOf(ms, ["1.5"])).toBe("MS");
    expect(lineOf(ms, ["2"])).toBe("MS,2");
  });

  it("refuses a sheet without what is required", () =>
    expect([...mistakesIn(circle, resetEntries(circle)).keys()]).toEqual([0]));

  it.each([
    ["4", undefined],
    ["4+1/2", undefined],
    ["&size", undefined],
    ["four", "This is not a number."],
  ])("%s as a diameter", (text, mistake) =>
    expect(mistakesIn(circle, [text, "T", "10", ""]).get(0)).toBe(mistake),
  );

  it("tells the range", () => {
    expect(mistakesIn(circle, ["4", "T", "100", ""]).get(2)).toBe("Allowed: 0 to 99.");
    expect(mistakesIn(circle, ["4", "T", "99", ""]).size).toBe(0);
  });

  it("makes the line of a part file, in its order and not longer than needed", () => {
    const entries = withEntry(resetEntries(circle), 0, "4");
    expect(lineOf(circle, entries)).toBe("CC,4");
    expect(lineOf(circle, withEntry(entries, 3, "-.25"))).toBe("CC,4,T,10,-.25");
    expect(lineOf(circle, withEntry(entries, 0, "a, b"))).toBe('CC,"a, b"');
  });
});
