import { describe, expect, it } from "vitest";
import { arcOf, bulgeThrough, distanceTo, meetings, placeAt, segmentBox } from "./segment";
import { place } from "./vec";

const segment = (x0: number, y0: number, x1: number, y1: number, bulge = 0) => ({
  from: place(x0, y0),
  to: place(x1, y1),
  bulge,
});

/** Bulges from (0,0) to (10,0): radius, centre and apex (readings, Bulge). */
const bulges: readonly [bulge: number, radius: number, centre: [number, number], apex: number][] = [
  [1, 5, [5, 0], -5],
  [0.414214, 7.0711, [5, 5], -2.0711],
  [0.5, 6.25, [5, 3.75], -2.5],
  [2, 6.25, [5, -3.75], -10],
  [-0.25, 10.625, [5, -9.375], 1.25],
];

describe("segments", () => {
  it.each(bulges)("has the arc of bulge %d", (bulge, radius, [x, y], apex) => {
    const curve = segment(0, 0, 10, 0, bulge);
    const arc = arcOf(curve);
    expect(arc.radius).toBeCloseTo(radius, 4);
    expect(arc.centre.x).toBeCloseTo(x, 4);
    expect(arc.centre.y).toBeCloseTo(y, 4);
    expect(placeAt(curve, 0.5).y).toBeCloseTo(apex, 4);
  });

  it("has its box with the bulge of the arc", () => {
    const { min, max } = segmentBox(segment(0, 0, 100, 0, 0.5));
    expect([min.x, max.x, min.y, max.y].map((v) => Math.round(v * 1e6) / 1e6)).toEqual([
      0, 100, -25, 0,
    ]);
  });

  it("measures to the ends beyond them, to the curve between", () => {
    expect(distanceTo(segment(0, 0, 10, 0), place(13, 4))).toBeCloseTo(5);
    expect(distanceTo(segment(0, 0, 10, 0, 1), place(5, -8))).toBeCloseTo(3);
    expect(distanceTo(segment(0, 0, 10, 0, 1), place(0, 3))).toBeCloseTo(3);
  });

  it("meets others, lines and arcs", () => {
    expect(meetings(segment(0, 0, 100, 100), segment(0, 100, 100, 0))).toEqual([place(50, 50)]);
    const [met] = meetings(segment(5, -9, 5, 9), segment(0, 0, 10, 0, 1));
    expect(met?.y).toBeCloseTo(-5);
    expect(meetings(segment(0, 0, 10, 0, 1), segment(3, -3, 13, -3, 1))).toHaveLength(1);
    expect(meetings(segment(0, 0, 1, 0), segment(0, 1, 1, 1))).toEqual([]);
  });

  it("bends to the mouse", () => {
    const [a, b] = [place(0, 0), place(10, 0)];
    expect(bulgeThrough(a, b, place(5, -5))).toBe(1);
    expect(bulgeThrough(a, b, place(5, 2.5))).toBe(-0.5);
    expect(bulgeThrough(a, b, place(5, 0))).toBeCloseTo(0);
    expect(bulgeThrough(place(0, 0), place(100, 0), place(50, -25))).toBe(0.5);
  });
});
