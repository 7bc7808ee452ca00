import { expect, test } from "vitest";
import { inches, mm } from "../units/quantity";
import type { AxisUnits } from "../wire/messages";
import { changeOf } from "./change";

const axes = ["X", "Y", "Z"].map((letter, at): { axis: AxisUnits; at: number } => ({
  axis: { letter, unit: "in", scale: inches.mm, used: true },
  at,
}));
const read = (text: string) => (text === "wide" ? undefined : mm(Number(text) * 25.4));

test("axes without a number stay", () => {
  const entries = { X: "2", Y: " ", Z: "0" };
  const values = [50.8, null, 0, null, null, null];
  expect(changeOf(axes, entries, read, "reads")).toEqual({ to: "reads", values });
  expect(changeOf(axes, entries, read, "lies")).toEqual({ to: "lies", at: values });
});

test("without a number, or with a word in its place, nothing is changed", () => {
  expect(changeOf(axes, {}, read, "reads")).toBe("Give a number for one axis at least.");
  expect(changeOf(axes, { Y: "wide" }, read, "lies")).toBe("Y: wide is no number.");
});
