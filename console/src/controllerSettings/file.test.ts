import { expect, it } from "vitest";
import type { ControllerSetting } from "../wire/messages";
import { differing, fileOf, found, unknownOf, valuesOf } from "./file";

const setting = (number: number, value: string, name = ""): ControllerSetting => ({
  number,
  value,
  name,
  unit: "mm/min",
  least: 0,
  most: null,
  does: "",
  own: "",
});
const settings = [setting(11, "0.010"), setting(110, "5000.000", "X greatest speed")];

it("reads what it wrote", () => {
  const text = fileOf("shop", settings);
  expect(text).toBe("; shop\n$11=0.010\n$110=5000.000\n");
  expect([...valuesOf(text)]).toEqual([
    [11, "0.010"],
    [110, "5000.000"],
  ]);
});

it("finds what differs in value and not in digits, and what the controller has not", () => {
  const values = valuesOf("$11=0.02 ; smoother\r\n$110=5000\n$999=1\nwords\n");
  expect(differing(settings, values)).toEqual([{ setting: settings[0], value: "0.02" }]);
  expect(unknownOf(settings, values)).toEqual([999]);
});

it("is found by number, by name and by unit", () => {
  const names = (search: string) =>
    found(settings, search, ({ name }) => name).map(({ number }) => number);
  expect(names("$110")).toEqual([110]);
  expect(names("speed x")).toEqual([110]);
  expect(names("mm/min")).toEqual([11, 110]);
  expect(names("spindle")).toEqual([]);
});
