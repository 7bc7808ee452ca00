import { expect, test } from "vitest";
import type { AxisUnits, Zero } from "../wire/messages";
import { takes } from "./take";

const axes: AxisUnits[] = ["X", "Y", "Z", "A"].map((letter) => ({
  letter,
  unit: letter === "A" ? "deg" : "in",
  scale: letter === "A" ? 1 : 25.4,
  used: true,
}));

test("a zero point that is taken reads zero where it is", () => {
  const zero: Zero = { name: "G54", at: [25.4, -50.8, 12.7, 90, 0, 0] };
  expect(takes(zero, [50.8, 0, 12.7, 90, 0, 0], axes)).toBe("VA,1,2,0");
  expect(takes(zero, [25.4, -50.8, 12.6999, 0, 0, 0], axes)).toBe("VA,0,0,-0.000004");
});
