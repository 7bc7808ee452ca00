import { expect, it } from "vitest";
import { inches, millimetres as metric, mm } from "../units/quantity";
import type { NumberedTool } from "../wire/messages";
import { diameterOf, entriesOf, lengthOf, newEntries, toolOf } from "./tool";

const tool = (number: number, more: Partial<NumberedTool> = {}): NumberedTool => ({
  number,
  name: "",
  diameter: mm(0),
  length: mm(0),
  measured: false,
  ...more,
});

it.each([
  [{ number: "2", name: " end mill ", diameter: "6", length: "-12.5" }, metric, [6, -12.5]],
  [{ number: "2", name: "end mill", diameter: "1/4", length: "" }, inches, [6.35, 0]],
])("a tool is read in the unit of the page: %o", (entries, unit, [diameter, length]) => {
  const change = { to: "is", name: "end mill", diameter, length };
  expect(toolOf(entries, unit)).toEqual({ number: 2, change });
});

it.each([
  [{ number: "0" }, "The number of a tool is 1 or more."],
  [{ number: "1.5" }, "The number of a tool is 1 or more."],
  [{ diameter: "-1" }, "The diameter is no length of 0 or more."],
  [{ length: "long" }, "The length is no length."],
])("what is no tool is told: %o", (wrong, told) => {
  const entries = { number: "1", name: "", diameter: "", length: "" };
  expect(toolOf({ ...entries, ...wrong }, metric)).toBe(told);
});

it("a form shows what is known, and reads back the same", () => {
  const known = tool(3, { name: "drill", diameter: mm(3.175), length: mm(-7), measured: true });
  const entries = entriesOf(known, inches);
  expect(entries).toEqual({ number: "3", name: "drill", diameter: "0.125", length: "-0.2756" });
  expect(lengthOf(known, metric)).toBe("-7");
  expect(diameterOf(known, metric)).toBe("3.175");
  expect([lengthOf(tool(1), metric), diameterOf(tool(1), metric)]).toEqual(["–", "–"]);
});

it("a new tool has the first number that is free", () => {
  expect(newEntries([tool(1), tool(2), tool(4)]).number).toBe("3");
  expect(newEntries([]).number).toBe("1");
});
