import { expect, it } from "vitest";
import { filledIn, valuesOf } from "./macros";

it.each<[string, [string, string][], string]>([
  ["JH", [], "JH"],
  [
    "JZ,{height=1}\nJ2,{x}",
    [
      ["height", "1"],
      ["x", ""],
    ],
    "JZ,7\nJ2,7",
  ],
  ["MX,{a}\nMY,{a=2}", [["a", "2"]], "MX,7\nMY,7"],
])("%s", (lines, values, filled) => {
  expect(valuesOf(lines).map(({ name, first }) => [name, first])).toEqual(values);
  expect(filledIn(lines, { height: "7", x: " 7 ", a: "7" })).toBe(filled);
});
