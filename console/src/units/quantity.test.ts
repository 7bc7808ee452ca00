import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import {
  degrees,
  difference,
  inAxisUnit,
  inches,
  inUnit,
  isMetric,
  millimetres,
  mm,
  mmPerS,
  namedUnit,
  ofAxisUnit,
  ofUnit,
  oneOf,
  perMinute,
  perMinuteInUnit,
  perMinuteOfUnit,
  perSecondInUnit,
  rounded,
  shown,
  shownOnAxis,
  shownPerMin,
} from "./quantity";

it("goes from millimetres to the unit of the page and back", () => {
  expect([inUnit(mm(50.8), inches), inUnit(mm(50.8), millimetres)]).toEqual([2, 50.8]);
  expect([ofUnit(shown(2), inches), ofUnit(shown(2), millimetres)]).toEqual([50.8, 2]);
  expect([isMetric(inches), isMetric(millimetres)]).toEqual([false, true]);
});

it("tells speeds by the second and by the minute", () => {
  expect(perSecondInUnit(mmPerS(50.8), inches)).toBe(2);
  expect(perMinuteInUnit(perMinute(mmPerS(50.8)), inches)).toBe(120);
  expect(perMinuteOfUnit(shownPerMin(120), inches)).toBe(3048);
});

it("leaves degrees of an axis that turns as they are", () => {
  const [turns, goes] = [{ scale: millimetres.mm }, { scale: inches.mm }];
  expect([inAxisUnit(degrees(90), turns), inAxisUnit(mm(25.4), goes)]).toEqual([90, 1]);
  expect([ofAxisUnit(shownOnAxis(90), turns), ofAxisUnit(shownOnAxis(1), goes)]).toEqual([
    90, 25.4,
  ]);
});

it("keeps the unit of differences and rounded values", () => {
  expect(difference(mm(5), mm(2))).toBe(3);
  expect(rounded(mm(1.23456), 100)).toBe(1.23);
});

it.each([
  ["mm", "in", 25.4],
  ["mm/s²", "in/s²", 25.4],
  ["mm/min", "in/min", 25.4],
  ["deg", "deg", 1],
  ["mm²", "mm²", 1],
])("knows %s by name", (name, wanted, size) => {
  expect(namedUnit(name, inches)).toEqual({ name: wanted, size });
  expect(namedUnit(name, millimetres)).toEqual({ name, size: 1 });
});

it("knows units that are written behind numbers", () => {
  expect(["MM", "in", "ft", "furlong", "constructor"].map(oneOf)).toEqual([
    1,
    25.4,
    304.8,
    undefined,
    undefined,
  ]);
});

it("only the doors and the makers of tests give a number its unit", () => {
  const source = join(import.meta.dirname, "..");
  const files = readdirSync(source, { recursive: true, encoding: "utf8" });
  const makes =
    /\bas (unknown as |number as )*(Mm|MmPer\w+|Degrees|Seconds|UnixSeconds|Shown\w*|Axis\w+|UnitSize)\b/;
  const found = files
    .filter((name) => /\.tsx?$/.test(name) && !name.startsWith("units"))
    .filter((name) => makes.test(readFileSync(join(source, name), "utf8")));
  expect(found).toEqual([]);
});
