import { describe, expect, it } from "vitest";
import { inches, millimetres } from "../units/quantity";
import type { SettingEntry } from "../wire/messages";
import { shownUnit, shownValue, writtenValue } from "./value";

const entry = (kind: SettingEntry["kind"], unit: string, value: string): SettingEntry => ({
  key: "a.b",
  kind,
  unit,
  value,
  bound: "",
  least: null,
  most: null,
  default: "",
  doc: "",
});
const speed = entry({ is: "number", none: false }, "mm/s", "50.8");
const table = entry({ is: "list", length: 3, none: false }, "mm", "[2540, 1270, 127]");
const free = entry({ is: "number", none: true }, "mm", "none");

describe("a setting", () => {
  it("is shown in inches where those are the unit, and in millimetres where those are", () => {
    expect([shownUnit(speed, inches).unit, shownValue(speed, inches)]).toEqual(["in/s", "2"]);
    expect([shownUnit(speed, millimetres).unit, shownValue(speed, millimetres)]).toEqual([
      "mm/s",
      "50.8",
    ]);
    expect(shownValue(table, inches)).toBe("100, 50, 5");
    expect(shownValue(free, inches)).toBe("none");
  });

  it("is written as the configuration has it", () => {
    expect(writtenValue(speed, "1+1/2", inches)).toBe("38.1");
    expect(writtenValue(table, "10, 20, 1/2", inches)).toBe("[254, 508, 12.7]");
    expect(writtenValue(free, "none", inches)).toBe("none");
    expect(writtenValue(speed, "fast?", millimetres)).toBeUndefined();
  });

  it("keeps angles and times as they are", () => {
    expect(shownUnit({ key: "a.b", unit: "deg" }, inches)).toEqual({ unit: "deg", scale: 1 });
    expect(shownUnit({ key: "a.b", unit: "s" }, inches)).toEqual({ unit: "s", scale: 1 });
  });

  it("pro_speeds_units: machine speeds are told in mm/s, cutting speeds in mm/min", () => {
    const cut = { ...speed, key: "smoothing.cut_speed_mm_s", value: "100" };
    expect([shownUnit(cut, millimetres).unit, shownValue(cut, millimetres)]).toEqual([
      "mm/min",
      "6000",
    ]);
    expect(writtenValue(cut, "6000", millimetres)).toBe("100");
    expect(writtenValue(cut, "12001", millimetres)).toBe("200.016667");
    expect([shownUnit(cut, inches).unit, writtenValue(cut, "60", inches)]).toEqual([
      "in/min",
      "25.4",
    ]);
    expect([shownUnit(speed, millimetres).unit, shownValue(speed, millimetres)]).toEqual([
      "mm/s",
      "50.8",
    ]);
    // A speed may also carry its unit.
    expect(writtenValue(cut, "50 mm/s", millimetres)).toBe("50 mm/s");
    expect(writtenValue(speed, "3000 mm/min", millimetres)).toBe("3000 mm/min");
    expect(writtenValue(cut, "20 rpm", millimetres)).toBeUndefined();
  });
});
