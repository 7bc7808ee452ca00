import { describe, expect, it } from "vitest";
import { boxOf, place } from "./geometry/vec";
import {
  boxInSight,
  fitted,
  panned,
  toDrawing,
  toPixels,
  type Window,
  zoomedAbout,
  zoomedTo,
} from "./window";

const size = { width: 200, height: 150 };
const window: Window = { middle: place(100, 75), mmPerPixel: 1 };

describe("the window on the drawing", () => {
  it("shows x to the right and y up, and leads back", () => {
    expect(toPixels(window, size, place(0, 0))).toEqual(place(0, 150));
    expect(toDrawing(window, size, place(0, 150))).toEqual(place(0, 0));
  });

  it("shows all data, larger by the expansion", () => {
    const square = { width: 100, height: 100 };
    const all = fitted(boxOf(place(0, 0), place(100, 100)), square);
    const { min, max } = boxInSight(all, square);
    expect([min.x, max.x]).toEqual([-2.5, 102.5]);
    const bare = boxInSight(fitted(boxOf(place(0, 0), place(100, 100)), square, 1), square);
    expect([bare.min.x, bare.max.x]).toEqual([0, 100]);
  });

  it("halves with Z and doubles with X about the mouse", () => {
    const half = boxInSight(zoomedTo(window, place(30, 40), 2), size);
    expect([half.max.x - half.min.x, half.max.y - half.min.y]).toEqual([100, 75]);
    const twice = boxInSight(zoomedTo(window, place(30, 40), 0.5), size);
    expect([twice.max.x - twice.min.x, (twice.max.x + twice.min.x) / 2]).toEqual([400, 30]);
  });

  it("keeps the place under the wheel", () => {
    const at = place(30, 40);
    const before = toPixels(window, size, at);
    const after = toPixels(zoomedAbout(window, at, 1.7), size, at);
    expect(after.x).toBeCloseTo(before.x);
    expect(after.y).toBeCloseTo(before.y);
  });

  it("follows the hand", () => {
    expect(panned(window, 10, 10).middle).toEqual(place(90, 85));
  });
});
