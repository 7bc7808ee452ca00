import { describe, expect, it } from "vitest";
import { readLength, readPlace } from "./entry";
import { place } from "./geometry/vec";

const inch = 25.4;

describe("typed lengths", () => {
  it.each([
    ["12.5", 12.5],
    ["3/4in+2mm", 21.05],
    ["-3/4in", -19.05],
    ["(10+5)/2", 7.5],
    ["2*(1+1)cm", 40],
    ["1ft", 304.8],
  ])("%s is %d mm", (text, mm) => {
    expect(readLength(text, 1)).toEqual({ value: expect.closeTo(mm, 9) });
  });

  it("takes the user's unit where none is typed", () => {
    expect(readLength("1", inch)).toEqual({ value: inch });
    expect(readLength("1+2mm", inch)).toEqual({ value: expect.closeTo(27.4, 9) });
  });

  it.each(["", "1+", "abc", "1 2", "(1", "1/0", "1furlong"])("%j is refused in words", (text) => {
    expect(readLength(text, 1)).toHaveProperty("wrong");
  });
});

describe("typed places", () => {
  const base = place(10, 20);

  it("reads them absolute, relative and polar", () => {
    expect(readPlace("1,2", 1, base)).toEqual({ value: place(1, 2) });
    expect(readPlace("@1,2", 1, base)).toEqual({ value: place(11, 22) });
    expect(readPlace("@1,-2", inch, null)).toEqual({ value: place(25.4, -50.8) });
    expect(readPlace("10<90", 1, base)).toEqual({
      value: { x: expect.closeTo(10, 9), y: expect.closeTo(30, 9) },
    });
  });

  it("says what a place is", () => {
    expect(readPlace("12", 1, base)).toHaveProperty("wrong");
    expect(readPlace("1,2,3", 1, base)).toHaveProperty("wrong");
    expect(readPlace("1,x", 1, base)).toHaveProperty("wrong");
  });
});
