import { describe, expect, it } from "vitest";
import { aspects, type Camera } from "./camera";
import { moved, noGesture, pressed, released } from "./gestures";

const camera: Camera = { target: [0, 0, 0], mmPerPixel: 1, ...aspects.solid };
const middle = { x: 100, y: 100 };
const press = (id: number, x: number, y: number, other = false) => ({ id, x, y, other });

describe("gestures on the tool path", () => {
  it("turns with the left button, pans with the others and in flat views", () => {
    expect(pressed(noGesture, press(1, 0, 0), false).kind).toBe("turn");
    expect(pressed(noGesture, press(1, 0, 0, true), false).kind).toBe("pan");
    expect(pressed(noGesture, press(1, 0, 0), true).kind).toBe("pan");
  });

  it("follows only the pointer that began", () => {
    const gesture = pressed(noGesture, press(1, 0, 0), true);
    expect(moved(gesture, camera, 2, { x: 50, y: 0 }, middle).camera).toBe(camera);
    expect(moved(gesture, camera, 1, { x: 50, y: 0 }, middle).camera).not.toEqual(camera);
    expect(moved(noGesture, camera, 1, { x: 50, y: 0 }, middle).camera).toBe(camera);
  });

  it("zooms with two fingers and pans with the one that stays", () => {
    const one = pressed(noGesture, press(1, 50, 100), false);
    const two = pressed(one, press(2, 150, 100), false);
    const apart = moved(two, camera, 2, { x: 250, y: 100 }, middle);
    expect(apart.camera.mmPerPixel).toBeCloseTo(0.5);
    const left = released(apart.gesture, 1);
    expect(left).toMatchObject({ kind: "pan", id: 2, at: { x: 250, y: 100 } });
    expect(released(left, 2)).toBe(noGesture);
    expect(released(left, 1)).toBe(left);
  });
});
