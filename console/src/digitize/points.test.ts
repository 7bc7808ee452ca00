import { describe, expect, it } from "vitest";
import { boxOf, noBox, place } from "../draw/geometry/vec";
import { boxInSight, fitted } from "../draw/window";
import { mm } from "../units/quantity";
import { message } from "../units/testing";
import type { Digitized } from "../wire/messages";
import { digitizedItem, type InSight, lookedAt } from "./points";

/** L(0,0), A(5,-5), L(10,0), L(10,10), the third one current. */
const digitized = message<Digitized>({
  origin: [0, 0],
  points: [
    { at: [0, 0, -5], arc: false },
    { at: [5, -5, -5], arc: true },
    { at: [10, 0, -5], arc: false },
    { at: [10, 10, -5], arc: false },
  ],
  bulges: [Math.tan(Math.PI / 8), Math.tan(Math.PI / 8), 0],
  current: 3,
  threeD: false,
  nextArc: false,
  unsaved: true,
});

const size = { width: 200, height: 200 };
const square = boxOf(place(0, 0), place(100, 100));
const seen: InSight = {
  window: fitted(square, size),
  size,
  data: square,
  points: null,
  machine: null,
  expansion: 1.05,
};

const sides = (look: Parameters<typeof lookedAt>[0], given: Partial<InSight> = {}) => {
  const all = { ...seen, ...given };
  const { min, max } = boxInSight(lookedAt(look, all), all.size);
  return { wide: max.x - min.x, high: max.y - min.y, min, max };
};

describe("digitized points", () => {
  it("are a path with all segments, one point marked as current", () => {
    const item = digitizedItem(digitized);
    expect(item.kind).toBe("digitized");
    expect(item.path.segments.length).toBe(3);
    expect(item.points.map(({ arc }) => arc)).toEqual([false, true, false, false]);
    expect(item.points.map(({ current }) => current)).toEqual([false, false, true, false]);
    expect(item.path.box.min.y).toBeCloseTo(-5);
    expect(item.path.box.max.y).toBe(10);
  });

  it("pro_digitize_d31: data limits are all shapes and 5 % more", () => {
    const { wide, high } = sides("data");
    expect([wide, high]).toEqual([105, 105]);
    const points = digitizedItem({
      ...digitized,
      points: [{ at: [mm(300), mm(50), mm(0)], arc: false }],
    });
    const more = sides("data", { points });
    expect(more.max.x).toBeGreaterThan(300);
    expect(more.min.x).toBeLessThan(0);
  });

  it("pro_digitize_d32: machine limits are the machine's bounds with the data", () => {
    const machine = boxOf(place(0, 0), place(2500, 1250));
    const { wide, high } = sides("machine", { machine, size: { width: 400, height: 200 } });
    expect(wide).toBeGreaterThanOrEqual(2625);
    expect(high).toBeGreaterThanOrEqual(1312.5);
    const beyond = boxOf(place(-200, 0), place(100, 100));
    expect(sides("machine", { machine, data: beyond }).min.x).toBeLessThan(-200);
  });

  it("pro_digitize_d33: zoom out shows twice as much about the same middle", () => {
    const window = { middle: place(100, 75), mmPerPixel: 1 };
    const { wide, high, min } = sides("out", { window, size: { width: 200, height: 150 } });
    expect([wide, high]).toEqual([400, 300]);
    expect([min.x, min.y]).toEqual([-100, -75]);
  });

  it("nothing to look at leaves the window as it is", () => {
    expect(lookedAt("data", { ...seen, data: noBox })).toBe(seen.window);
    expect(lookedAt("digitized", seen)).toBe(seen.window);
  });
});
