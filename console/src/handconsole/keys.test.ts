import { expect, it } from "vitest";
import { keyOf, pad } from "./keys";

it("has sixteen keys, each its own", () => {
  expect(new Set(pad.map(({ key }) => key))).toEqual(new Set("0123456789-\rFSPU"));
  expect(pad).toHaveLength(16);
});

it.each([
  ["F9", "F"],
  ["F10", "S"],
  ["F11", "P"],
  ["F12", "U"],
  ["Numpad0", "0"],
  ["Numpad9", "9"],
  ["NumpadEnter", "\r"],
  ["NumpadSubtract", "-"],
  ["NumpadDecimal", "F"],
])("%s is the key %j", (code, key) => expect(keyOf(code, false)?.key).toBe(key));

it("leaves other keys, and the keypad to whoever types", () => {
  for (const code of ["Digit0", "Enter", "KeyF", "F8"]) expect(keyOf(code, false)).toBeUndefined();
  expect(keyOf("Numpad7", true)).toBeUndefined();
  expect(keyOf("F11", true)?.key).toBe("P");
});
