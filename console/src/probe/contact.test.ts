import { expect, test } from "vitest";
import { isChecked, seen, unchecked } from "./contact";

test.each([
  [[], false],
  [[false, false], false],
  [[true], false],
  [[true, false], true],
  [[true, false, true], false],
])("inputs %j: %s", (inputs, checked) => {
  expect(isChecked(inputs.reduce(seen, unchecked))).toBe(checked);
});
