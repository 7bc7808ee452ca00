import { expect, test } from "vitest";
import { mm } from "../units/quantity";
import { squareness, truerSteps, withNumber } from "./tuning";

test("a way that came out short needs more steps", () => {
  expect(truerSteps(80, mm(100), mm(99))).toBeCloseTo(80.808, 3);
  expect(truerSteps(80, mm(100), mm(100))).toBe(80);
});

test.each([[0], [0.3], [-0.8]])("a rectangle that leans by %d degrees is found to", (degrees) => {
  const [x, y, angle] = [400, 300, (degrees * Math.PI) / 180];
  const [right, up] = [y * Math.sin(angle), y * Math.cos(angle)];
  const [d1, d2] = [mm(Math.hypot(x + right, up)), mm(Math.hypot(x - right, up))];
  const found = squareness(mm(x), mm(y), d1, d2, mm(1000));
  expect(found?.degrees).toBeCloseTo(degrees, 9);
  expect(found?.front).toBeCloseTo(1000 * Math.tan(angle), 9);
});

test("diagonals that no rectangle has are nothing", () => {
  expect(squareness(mm(10), mm(10), mm(100), mm(1), mm(10))).toBeUndefined();
});

test("one number of a list is another", () => {
  expect(withNumber("[80, 80, 400]", 1, 80.5)).toBe("[80, 80.5, 400]");
});
