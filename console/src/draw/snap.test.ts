import { describe, expect, it } from "vitest";
import { shapeOf } from "./geometry/shape";
import { place } from "./geometry/vec";
import { pickingOf, shapesNear } from "./pick";
import { keysAt, type SnapKey, snapped } from "./snap";

const path = (number: number, points: readonly number[], closed = false) =>
  shapeOf({ number, group: "black", closed, pause: false, z: null, points: [...points] });

const square = path(1, [0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0], true);
const at = (
  key: SnapKey | null,
  x: number,
  y: number,
  shapes = [square],
  base: { x: number; y: number } | null = null,
) => snapped(key, place(x, y), pickingOf(shapes), 8, base);

describe("snaps, radius 8 mm", () => {
  it("pro_snap_vertex: V takes the nearest vertex, or nothing", () => {
    expect(at("v", 98, 102)).toEqual(place(100, 100));
    expect(at("v", 50, 3)).toBeNull();
  });

  it("pro_snap_centre: C takes the centre of the nearest arc", () => {
    const arc = path(1, [0, 0, 0.5, 10, 0, 0]);
    expect(at("c", 5, -2.5, [arc])?.y).toBeCloseTo(3.75);
    expect(at("c", 50, 1)).toBeNull();
  });

  it("pro_snap_midpoint: M takes a midpoint when the middle three fifths are near", () => {
    const line = path(1, [0, 0, 0, 100, 0, 0]);
    expect(at("m", 25, 3, [line])).toEqual(place(50, 0));
    expect(at("m", 5, 3, [line])).toBeNull();
    const arc = path(1, [0, 0, 1, 10, 0, 0]);
    expect(at("m", 5, -4, [arc])?.y).toBeCloseTo(-5);
  });

  it("pro_snap_intersection: I takes the nearest crossing of shapes, not the corners of one", () => {
    const crossed = [path(1, [0, 0, 0, 100, 100, 0]), path(2, [0, 100, 0, 100, 0, 0])];
    expect(at("i", 53, 52, crossed)).toEqual(place(50, 50));
    expect(at("i", 99, 99)).toBeNull();
  });

  it("pro_snap_nearest: N takes the nearest place on a shape", () => {
    expect(at("n", 40, 3)).toEqual(place(40, 0));
    expect(at("n", 40, 9)).toBeNull();
  });

  it("pro_snap_ortho: G is square to the base point", () => {
    const base = place(10, 20);
    expect(at("g", 60, 35, [square], base)).toEqual(place(60, 20));
    expect(at("g", 15, 90, [square], base)).toEqual(place(10, 90));
    expect(at("g", 30, 40, [square], base)).toEqual(place(10, 40));
  });

  it("Q, no key, takes the mouse", () => {
    expect(at(null, 98, 102)).toEqual(place(98, 102));
  });

  it("offers G only with a base point", () => {
    expect(keysAt(null)).toBe("VCMINQ");
    expect(keysAt(place(0, 0))).toBe("VCMINGQ");
  });
});

describe("picking", () => {
  it("pro_select_radius: takes shapes within the radius only, in cutting order", () => {
    const copy = { ...square, number: 2, group: "red" };
    const picking = pickingOf([copy, square]);
    expect(shapesNear(picking, place(107.9, 50), 8).map((s) => s.number)).toEqual([1, 2]);
    expect(shapesNear(picking, place(108.1, 50), 8)).toEqual([]);
  });
});
