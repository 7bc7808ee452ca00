import { describe, expect, it } from "vitest";
import { inches, millimetres } from "../units/quantity";
import type { Units } from "../wire/messages";
import { inUnits } from "./inUnits";

const imperial: Units = { ...inches, axes: [], absolute: true };
const metric: Units = { ...imperial, ...millimetres };

describe("a sentence in the unit of the page", () => {
  it.each([
    [
      "shape 1: it would be cut at -32.7 mm, below ZBottom at -30 mm",
      "shape 1: it would be cut at -1.2874 in, below ZBottom at -1.1811 in",
    ],
    ["shape 1 at 7.62,-3.175: too small", "shape 1 at 0.3,-0.125 in: too small"],
    ["3 x 4 dots on 25.4 x 50.8 mm", "3 x 4 dots on 1 x 2 in"],
    [
      "group red: 1270 mm/min is limited to 635 mm/min",
      "group red: 50 in/min is limited to 25 in/min",
    ],
    ["X reaches 25.4 mm/s", "X reaches 1 in/s"],
    ["line 12: 3 moves, tool 25 of 30", "line 12: 3 moves, tool 25 of 30"],
    ["a2.5 mm and 5 mmx stay", "a2.5 mm and 5 mmx stay"],
  ])("%s", (text, wanted) => expect(inUnits(text, imperial)).toBe(wanted));

  it("stays in millimetres where those are read", () => {
    const text = "its helix of 5 mm would cut into shape 2 at 1,2: one of 3 mm is cut";
    expect(inUnits(text, metric)).toBe(
      "its helix of 5 mm would cut into shape 2 at 1,2 mm: one of 3 mm is cut",
    );
    expect(inUnits(text, undefined)).toBe(text);
  });
});
