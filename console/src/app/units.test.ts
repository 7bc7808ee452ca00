import { describe, expect, it } from "vitest";
import { inches, millimetres, mm, mmPerS, seconds } from "../units/quantity";
import type { AxisUnits, Units } from "../wire/messages";
import { durationText, lengthText, locationText, speedText, usedAxes } from "./units";

const x: AxisUnits = { letter: "X", unit: "in", scale: inches.mm, used: true };
const axes = [x, { ...x, letter: "A", used: false }];
const imperial: Units = { ...inches, axes, absolute: true };

describe("what a person reads", () => {
  it("shows locations in the unit of the axis", () => {
    expect(locationText(mm(50.8), x)).toBe("2.000");
    expect(locationText(mm(-3.175), x)).toBe("-0.125");
    expect(locationText(mm(50.8), { ...x, unit: "mm", scale: millimetres.mm })).toBe("50.800");
  });

  it("shows no minus before nothing", () => expect(locationText(mm(-1e-9), x)).toBe("0.000"));

  it("shows speeds and lengths", () => {
    expect(speedText(mmPerS(38.1), inches)).toBe("1.50");
    expect(speedText(mmPerS(38.1), millimetres)).toBe("38.1");
    expect(lengthText(mm(254), inches)).toBe("10.00 in");
  });

  it("shows durations", () => {
    const cases: [number, string][] = [
      [0, "0:00"],
      [-3, "0:00"],
      [59.2, "1:00"],
      [61, "1:01"],
      [3723, "1:02:03"],
    ];
    for (const [time, text] of cases) expect(durationText(seconds(time))).toBe(text);
  });

  it("shows the axes there are", () => expect(usedAxes(imperial).map(({ at }) => at)).toEqual([0]));
});
