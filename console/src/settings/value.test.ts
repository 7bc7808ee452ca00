import { describe, expect, it } from "vitest";
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
    expect([shownUnit("mm/s", 25.4).unit, shownValue(speed, 25.4)]).toEqual(["in/s", "2"]);
    expect([shownUnit("mm/s", 1).unit, shownValue(speed, 1)]).toEqual(["mm/s", "50.8"]);
    expect(shownValue(table, 25.4)).toBe("100, 50, 5");
    expect(shownValue(free, 25.4)).toBe("none");
  });

  it("is written as the configuration has it", () => {
    expect(writtenValue(speed, "1+1/2", 25.4)).toBe("38.1");
    expect(writtenValue(table, "10, 20, 1/2", 25.4)).toBe("[254, 508, 12.7]");
    expect(writtenValue(free, "none", 25.4)).toBe("none");
    expect(writtenValue(speed, "fast?", 1)).toBeUndefined();
  });

  it("keeps angles and times as they are", () => {
    expect(shownUnit("deg", 25.4)).toEqual({ unit: "deg", scale: 1 });
    expect(shownUnit("s", 25.4)).toEqual({ unit: "s", scale: 1 });
  });
});
