import { expect, it } from "vitest";
import { drawingWords } from "./drawingWords";

it.each([
  ["clause 1: group red: no height", "layer red: no height"],
  ["a 3D path is entered straight down, without the tag of its group", null],
  ["clause 2 `move x`: a place is missing; write `move from X,Y`", "a place is missing"],
  ["Groups", "Layers"],
  ["Tag", "Tab"],
  [
    "say depth=thru where the area is to fall out",
    "say depth=through where the area is to fall out",
  ],
  ["grouped shapes stay", "grouped shapes stay"],
])("%s", (text, wanted) => {
  const said = wanted ?? "a 3D path is entered straight down, without the tab of its layer";
  expect(drawingWords(text)).toBe(said);
});
