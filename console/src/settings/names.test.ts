import { expect, it } from "vitest";
import { boundText, fullName, shortName, starred } from "./names";

it.each([
  ["speeds.cut.xy", "speeds.cut.*", "Speeds, cut, xy", "Cut, xy", "Cut"],
  ["homing.z.fast", "homing.*.fast", "Homing, Search, Z", "Search, Z", "Search"],
  ["board.home_x2", "board.home_*", "Board, Home switch, X2", "Home switch, X2", "Home switch"],
  ["m6_runs_c9", "m6_runs_c9", "M6 changes the tool", "M6 changes the tool", "M6 changes the tool"],
  ["axis.length", "axis.length", "Axis, length", "Length", "Length"],
  ["pendant.close", "pendant.close", "Pendant, close", "Close", "Close"],
])("the names of %s", (key, table, full, short, row) => {
  expect([starred(key), fullName(key), shortName(key), shortName(key, true)]).toEqual([
    table,
    full,
    short,
    row,
  ]);
});

it.each(["3 to 6", "0 or greater", "greater than 0", "greater than 0, or inf", ""])(
  "a bound stays as it is said: %s",
  (bound) => expect(boundText(bound)).toBe(bound),
);
