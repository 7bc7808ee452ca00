import { describe, expect, it } from "vitest";
import type { Units } from "../wire/messages";
import { durationText, lengthText, locationText, speedText, usedAxes } from "./units";

const x = { letter: "X", unit: "in", scale: 25.4, used: true };
const inches: Units = {
  linear: "in",
  mm: 25.4,
  axes: [x, { ...x, letter: "A", used: false }],
  absolute: true,
};
const millimetres: Units = { ...inches, linear: "mm", mm: 1 };

describe("what a person reads", () => {
  it("shows locations in the unit of the axis", () => {
    expect(locationText(50.8, x)).toBe("2.000");
    expect(locationText(-3.175, x)).toBe("-0.125");
    expect(locationText(50.8, { ...x, unit: "mm", scale: 1 })).toBe("50.800");
  });

  it("shows no minus before nothing", () => expect(locationText(-1e-9, x)).toBe("0.000"));

  it("shows speeds and lengths", () => {
    expect(speedText(38.1, inches)).toBe("1.50");
    expect(speedText(38.1, millimetres)).toBe("38.1");
    expect(lengthText(254, inches)).toBe("10.00 in");
  });

  it("shows durations", () => {
    const cases: [number, string][] = [
      [0, "0:00"],
      [-3, "0:00"],
      [59.2, "1:00"],
      [61, "1:01"],
      [3723, "1:02:03"],
    ];
    for (const [seconds, text] of cases) expect(durationText(seconds)).toBe(text);
  });

  it("shows the axes there are", () => expect(usedAxes(inches).map(({ at }) => at)).toEqual([0]));
});
