import { describe, expect, it } from "vitest";
import { aspects, type Camera, fit as fitted, pan, project, turn, zoom } from "./camera";

const size = { width: 400, height: 300 };
const top: Camera = { target: [0, 0, 0], mmPerPixel: 0.5, ...aspects.top };

describe("the camera", () => {
  it("looks down on the table: X to the right, Y up", () => {
    expect(project(top, [10, 0, 0], size)).toEqual({ x: 220, y: 150 });
    expect(project(top, [0, 10, 0], size)).toEqual({ x: 200, y: 130 });
    expect(project(top, [0, 0, 10], size).y).toBeCloseTo(150);
  });

  it("looks from the front: Z up", () => {
    const front = { ...top, ...aspects.front };
    expect(project(front, [10, 50, 10], size).x).toBeCloseTo(220);
    expect(project(front, [10, 50, 10], size).y).toBeCloseTo(130);
  });

  it("pans with the pointer", () => {
    const at = project(pan(top, 7, -9), [0, 0, 0], size);
    expect([at.x, at.y]).toEqual([207, 141]);
  });

  it("zooms about the pointer", () => {
    for (const aspect of [aspects.top, aspects.front, aspects.side]) {
      const camera = { ...top, ...aspect };
      const under = project(camera, [20, 20, 20], size);
      const closer = zoom(camera, 3, under.x - 200, under.y - 150);
      const then = project(closer, [20, 20, 20], size);
      expect(then.x).toBeCloseTo(under.x);
      expect(then.y).toBeCloseTo(under.y);
      expect(closer.mmPerPixel).toBeCloseTo(0.5 / 3);
    }
  });

  it("zooms neither to nothing nor to infinity", () => {
    expect(zoom(top, 1e12, 0, 0).mmPerPixel).toBe(1e-4);
    expect(zoom(top, 1e-12, 0, 0).mmPerPixel).toBe(1e3);
  });

  it("does not turn over", () => {
    expect(turn(top, 0, 5000).tiltRad).toBe(0);
    expect(turn(top, 0, -5000).tiltRad).toBe(Math.PI);
  });

  it("fits a box from every side", () => {
    const bounds = { min: [-10, 0, -5], max: [90, 40, 5] } as const;
    for (const aspect of Object.values(aspects)) {
      const camera = fitted({ ...top, ...aspect }, bounds, size);
      for (const x of [-10, 90])
        for (const y of [0, 40]) {
          const at = project(camera, [x, y, 0], size);
          expect(at.x).toBeGreaterThan(0);
          expect(at.x).toBeLessThan(size.width);
          expect(at.y).toBeGreaterThan(0);
          expect(at.y).toBeLessThan(size.height);
        }
    }
  });

  it("fits a single point", () => {
    const here = fitted(top, { min: [1, 2, 3], max: [1, 2, 3] }, size);
    expect(here.target).toEqual([1, 2, 3]);
    expect(here.mmPerPixel).toBeGreaterThan(0);
  });
});
