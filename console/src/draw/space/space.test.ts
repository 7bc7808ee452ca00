/** Rows of the Profiler reference about the drawing in space, with its numbers. */

import { describe, expect, it } from "vitest";
import { firstSnapshot } from "../../../tests/standin/snapshot";
import { mm } from "../../units/quantity";
import { message } from "../../units/testing";
import { axesOf, project, type Vec3 } from "../../view/camera";
import type { ZHeights } from "../../wire/messages";
import { type Place, place } from "../geometry/vec";
import { optionWords, type ViewOptions } from "../options";
import { loadedOf, notMachined, type Scene, sceneOf } from "../scene";
import { boundsOfItems, type Item, itemsOf } from "./items";
import { toolIn } from "./lift";
import {
  type Aspect,
  firstSpace,
  keyed,
  lookFrom,
  movedTo,
  pressedAt,
  profile,
  readout,
  type Space,
  zoomedAt,
} from "./space";

const sim = message<ZHeights>({ top: -10, surface: -20, bottom: -30 });
const size = { width: 400, height: 300 };
const bounds = { min: [0, 0, -30], max: [100, 100, -10] } as const;
const options = Object.fromEntries(
  Object.keys(optionWords).map((key) => [key, false]),
) as unknown as ViewOptions;

const seen = (aspect: Aspect): Space => lookFrom({ ...firstSpace, size }, aspect, bounds);

/** A scene with one shape; flat unless it has heights. */
function sceneOfOne(points: number[], closed = false, z: number[] | null = null): Scene {
  const shape = { number: 1, group: "black", closed, points, z, pause: false };
  return sceneOf(loadedOf({ revision: 1, shapes: [shape] }), null, notMachined, options);
}

const square = sceneOfOne([0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0], true);

const items = (scene: Scene, levels: number[], heights = sim, machine: Vec3 | null = null) =>
  itemsOf(scene, { groups: [{ name: "black", levels } as never], heights, machine });

const lines = (found: readonly Item[]): (readonly Vec3[])[] =>
  found.flatMap((item) => (item.kind === "shape" ? [item.line] : []));

const heights = (found: readonly Item[]) =>
  lines(found).map((line) => [...new Set(line.map(([, , z]) => z))]);

/** Place in the picture: to the right and upwards from the middle of what is looked at. */
function inView(aspect: Aspect, [x, y, z]: Vec3): [number, number] {
  const { right, up } = axesOf(seen(aspect).camera);
  const along = (way: Vec3) => way[0] * x + way[1] * y + way[2] * z;
  return [along(right), along(up)];
}

const near = (found: readonly number[], expected: readonly number[]) =>
  found.forEach((value, n) => {
    expect(value).toBeCloseTo(expected[n] ?? Number.NaN, 9);
  });

const own = (scene: Scene) => lines(items(scene, [], { ...sim, surface: mm(0) }))[0] ?? [];

describe("directions", () => {
  it("pro_display_view3d: unit vectors of all axes are equally long", () => {
    for (const unit of [[1, 0, 0] as const, [0, 1, 0] as const, [0, 0, 1] as const]) {
      expect(Math.hypot(...inView("solid", unit))).toBeCloseTo(0.8165, 4);
    }
  });

  it("pro_display_sideview: y to the right, z upwards", () => {
    const [from, to] = own(sceneOfOne([0, 0, 0, 0, 10, 0], false, [0, -5]));
    near(inView("side", from ?? [1, 1, 1]), [0, 0]);
    near(inView("side", to ?? [1, 1, 1]), [10, -5]);
  });

  it("pro_display_endview: x to the right, z upwards", () => {
    const [from, to] = own(sceneOfOne([0, 0, 0, 10, 0, 0], false, [0, -5]));
    near(inView("end", from ?? [1, 1, 1]), [0, 0]);
    near(inView("end", to ?? [1, 1, 1]), [10, -5]);
  });

  it("pro_display_bounds_3d: a box, in which flat shapes have no height", () => {
    const line = own(sceneOfOne([0, 0, 0, 10, 20, 0], false, [-5, 3]));
    const only = [{ kind: "shape", ink: "--x", dash: false, line: [...line] }] as const;
    expect(boundsOfItems(only)).toEqual({ min: [0, 0, -5], max: [10, 20, 3] });
  });
});

describe("windows in space", () => {
  const at = place(150, 100);
  const wide = (space: Space) => space.camera.mmPerPixel * size.width;
  const way = ({ camera }: Space) => [camera.yawRad, camera.tiltRad];

  it("pro_display_v3d_zoompan: zooming and panning keep the direction", () => {
    for (const aspect of ["side", "end", "solid"] as const) {
      const before = { ...seen(aspect), pointer: at };
      const near = keyed(before, "z", bounds) ?? before;
      const far = keyed(before, "x", bounds) ?? before;
      const panned = keyed(before, "s", bounds) ?? before;
      expect(wide(near)).toBeCloseTo(wide(before) / 2, 9);
      expect(wide(far)).toBeCloseTo(wide(before) * 2, 9);
      expect(wide(panned)).toBe(wide(before));
      for (const after of [near, far, panned]) expect(way(after)).toEqual(way(before));
      // What was under the mouse is in the middle.
      expect(near.camera.target).toEqual(panned.camera.target);
    }
  });

  it("pro_display_v3d_mousexy: the mouse is read on the z-plane", () => {
    for (const aspect of ["top", "solid"] as const) {
      const space = { ...seen(aspect), zPlane: -10, pointer: place(123, 45) };
      const read = readout(space);
      const back = project(space.camera, [read?.x ?? 0, read?.y ?? 0, -10], size);
      expect(Math.hypot(back.x - 123, back.y - 45)).toBeLessThan(0.5);
    }
    const down = { ...seen("top"), zPlane: -10, pointer: place(123, 45) };
    expect(readout(down)).toEqual(readout({ ...down, zPlane: 0 }));
    expect(readout({ ...seen("side"), pointer: place(1, 1) })).toBeNull();
  });

  it("pro_display_v3d_zplane: panning and zooming from the side set the plane", () => {
    const press = (space: Space, { x, y }: Place) =>
      pressedAt(space, { id: 1, x, y, other: false });
    for (const aspect of ["side", "end"] as const) {
      const space = seen(aspect);
      const height = project(space.camera, [0, 0, -15], size);
      expect(press(space, height).zPlane).toBeCloseTo(-15, 9);
      expect(zoomedAt(space, height, 2).zPlane).toBeCloseTo(-15, 9);
    }
    expect(press({ ...seen("top"), zPlane: -7 }, place(20, 20)).zPlane).toBe(-7);
  });

  it("tells the mouse along the picture from the side", () => {
    const space = seen("side");
    const moved = movedTo(space, 1, project(space.camera, [0, 40, -12], size));
    expect(profile(moved)?.along).toBeCloseTo(40, 9);
    expect(profile(moved)?.z).toBeCloseTo(-12, 9);
  });
});

describe("heights", () => {
  it("pro_display_v3d_thru: through is the plane of ZBottom", () => {
    expect(heights(items(square, [-30]))).toEqual([[-30]]);
    expect(heights(items(square, [-31], { ...sim, bottom: mm(-31) }))).toEqual([[-31]]);
  });

  it("pro_display_v3d_mm: a depth counts from ZSurface", () => {
    expect(heights(items(square, [-22]))).toEqual([[-22]]);
    expect(heights(items(square, [-17]))).toEqual([[-17]]);
  });

  it("pro_display_v3d_multipass: once for each pass", () => {
    const found = items(square, [-24, -28, -32, -33]);
    expect(heights(found)).toEqual([[-24], [-28], [-32], [-33]]);
  });

  it("draws arcs as arcs, and what has its own heights from the surface on", () => {
    const arc = lines(items(sceneOfOne([0, 0, 1, 10, 0, 0]), [-22]))[0] ?? [];
    expect(arc.length).toBeGreaterThan(20);
    for (const [x, y] of arc) expect(Math.hypot(x - 5, y)).toBeCloseTo(5, 9);
    expect(heights(items(sceneOfOne([0, 0, 0, 9, 0, 0], false, [-3, 2]), []))).toEqual([
      [-23, -18],
    ]);
  });

  it("pro_display_v3d_machine: the tool where the machine is", () => {
    const machine = items(square, [-30], sim, [10, 20, -5]).filter(
      ({ kind }) => kind === "machine",
    );
    expect(machine).toEqual([{ kind: "machine", at: [10, 20, -5], ink: "--view-tool" }]);
    const { motion } = firstSnapshot;
    const at = (working: number[]) =>
      toolIn({ ...motion, at: { ...motion.at, working: working as never } }, sim);
    expect([at([10, 20, 15]), at([11, 20, 15])]).toEqual([
      [10, 20, -5],
      [11, 20, -5],
    ]);
  });

  it("pro_display_v3d_levels: the three special heights, as they are set", () => {
    const levels = (set: typeof sim) =>
      items(square, [-30], set).flatMap((item) =>
        item.kind === "level" ? [[item.name, item.z, item.line[0]?.[2]]] : [],
      );
    expect(levels(sim)).toEqual([
      ["ZTop", -10, -10],
      ["ZSurface", -20, -20],
      ["ZBottom", -30, -30],
    ]);
    expect(levels({ ...sim, surface: mm(-21) })[1]).toEqual(["ZSurface", -21, -21]);
  });
});
