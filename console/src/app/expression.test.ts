import { describe, expect, it } from "vitest";
import { inches, millimetres } from "../units/quantity";
import { evaluate, isExpression, lengthOf, resultText } from "./expression";

describe("arithmetic in a field", () => {
  const cases: [string, number][] = [
    ["12+11/16", 12.6875],
    ["2*(1.5-1/8)", 2.75],
    ["-2^2", -4],
    ["2^-1", 0.5],
    ["8/4/2", 1],
    [" .5 ", 0.5],
    ["1e3", 1000],
    ["sqrt(2)*sqrt(2)", 2],
    ["sin(pi/6)", 0.5],
    ["atn(1)*4", Math.PI],
    ["--3", 3],
    ["2*pi", 2 * Math.PI],
  ];
  it.each(cases)("%s", (text, value) => expect(evaluate(text)).toBeCloseTo(value, 9));

  const lengths: [string, number][] = [
    ["3/4in + 2mm", 0.75 + 2 / 25.4],
    ["25.4mm", 1],
    ['1/2"', 0.5],
    ["2cm*2", Number.NaN],
    ["1ft", 12],
    ["3", 3],
  ];
  it.each(lengths)("%s in a field of inches", (text, value) =>
    Number.isNaN(value)
      ? expect(evaluate(text, inches)).toBeUndefined()
      : expect(evaluate(text, inches)).toBeCloseTo(value, 9),
  );

  it.each(["", "2+", "(2", "2)", "two", "2 3", "1/0", "sqrt 4", "&x", "@"])(
    "%s has no value",
    (text) => expect(evaluate(text)).toBeUndefined(),
  );

  it("is a length of the page's unit where it says none", () => {
    expect(lengthOf("3/4", inches)).toBeCloseTo(19.05, 9);
    expect(lengthOf("3/4in", millimetres)).toBeCloseTo(19.05, 9);
    expect(lengthOf("two", inches)).toBeUndefined();
  });

  it("tells a number from an expression", () => {
    expect(isExpression("12")).toBe(false);
    expect(isExpression("12+1")).toBe(true);
    expect(isExpression("OFF")).toBe(false);
  });

  it("shows results without a tail of zeros", () => {
    expect(resultText(12.6875)).toBe("12.6875");
    expect(resultText(0.1 + 0.2)).toBe("0.3");
  });
});
