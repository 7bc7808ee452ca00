import { expect, test } from "vitest";
import { type AxisPlace, inches, millimetres } from "../units/quantity";
import { message, type Unmarked } from "../units/testing";
import type { AxisUnits, Zero } from "../wire/messages";
import { takes } from "./take";

const axes: AxisUnits[] = ["X", "Y", "Z", "A"].map((letter) => ({
  letter,
  unit: letter === "A" ? "deg" : "in",
  scale: letter === "A" ? millimetres.mm : inches.mm,
  used: true,
}));

test("a zero point that is taken reads zero where it is", () => {
  const zero = message<Zero>({ name: "G54", at: [25.4, -50.8, 12.7, 90, 0, 0] });
  const at = (place: Unmarked<AxisPlace>) => takes(zero, message<AxisPlace>(place), axes);
  expect(at([50.8, 0, 12.7, 90, 0, 0])).toBe("VA,1,2,0");
  expect(at([25.4, -50.8, 12.6999, 0, 0, 0])).toBe("VA,0,0,-0.000004");
});
