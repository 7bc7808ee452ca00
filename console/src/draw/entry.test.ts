import { describe, expect, it } from "vitest";
import { inches, millimetres } from "../units/quantity";
import { readLength, readPlace, readSpeed } from "./entry";
import { place } from "./geometry/vec";

describe("typed lengths", () => {
  it.each([
    ["12.5", 12.5],
    ["3/4in+2mm", 21.05],
    ["-3/4in", -19.05],
    ["(10+5)/2", 7.5],
    ["2*(1+1)cm", 40],
    ["1ft", 304.8],
  ])("%s is %d mm", (text, length) => {
    expect(readLength(text, millimetres)).toEqual({ value: expect.closeTo(length, 9) });
  });

  it("takes the user's unit where none is typed", () => {
    expect(readLength("1", inches)).toEqual({ value: 25.4 });
    expect(readLength("1+2mm", inches)).toEqual({ value: expect.closeTo(27.4, 9) });
  });

  it("takes speeds a minute in the user's unit too", () => {
    expect(readSpeed("50", inches)).toEqual({ value: 1270 });
    expect(readSpeed("1270mm", inches)).toEqual({ value: expect.closeTo(1270, 9) });
  });

  it.each(["", "1+", "abc", "1 2", "(1", "1/0", "1furlong"])("%j is refused in words", (text) => {
    expect(readLength(text, millimetres)).toHaveProperty("wrong");
  });
});

describe("typed places", () => {
  const base = place(10, 20);

  it("reads them absolute, relative and polar", () => {
    expect(readPlace("1,2", millimetres, base)).toEqual({ value: place(1, 2) });
    expect(readPlace("@1,2", millimetres, base)).toEqual({ value: place(11, 22) });
    expect(readPlace("@1,-2", inches, null)).toEqual({ value: place(25.4, -50.8) });
    expect(readPlace("10<90", millimetres, base)).toEqual({
      value: { x: expect.closeTo(10, 9), y: expect.closeTo(30, 9) },
    });
  });

  it("says what a place is", () => {
    expect(readPlace("12", millimetres, base)).toHaveProperty("wrong");
    expect(readPlace("1,2,3", millimetres, base)).toHaveProperty("wrong");
    expect(readPlace("1,x", millimetres, base)).toHaveProperty("wrong");
  });
});
