import { expect, it } from "vitest";
import { allMinutes, changed, hoursSince, stepsOf, textOf } from "./steps";

it("reads steps and writes them as they are kept", () => {
  const steps = stepsOf("25:2, 50 : 1.5,");
  expect(steps).toEqual([
    { percent: "25", minutes: "2" },
    { percent: "50", minutes: "1.5" },
  ]);
  expect(textOf(changed(steps, 1, { minutes: "3" }))).toBe("25:2, 50:3");
  expect(stepsOf("")).toEqual([]);
});

it("adds the minutes, and knows none where one is missing", () => {
  expect(allMinutes(stepsOf("25:2,50:1.5"))).toBe(3.5);
  expect(allMinutes(stepsOf("25:2,50:"))).toBeUndefined();
  expect(allMinutes(stepsOf("25:two"))).toBeUndefined();
});

it("tells the hours since the last run ended", () => {
  const run = (begun: number, seconds: number) => ({ begun, seconds });
  expect(hoursSince([], 9000)).toBeUndefined();
  expect(hoursSince([run(0, 60), run(1000, 800)], 9000)).toBe(2);
  expect(hoursSince([run(9000, 100)], 9000)).toBe(0);
});
