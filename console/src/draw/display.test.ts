/** Rows of the Profiler reference about what is seen of a drawing, with its numbers. */

import { describe, expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import { type Mm, mm } from "../units/quantity";
import type { GroupState, ToolPaths } from "../wire/messages";
import { boxOfShapes, type Shape, shapeOf } from "./geometry/shape";
import { place } from "./geometry/vec";
import { coloursOf } from "./inks";
import { optionWords, type ViewOption, type ViewOptions } from "./options";
import { shapesNear } from "./pick";
import { type Mark, pictureOf } from "./picture";
import { loadedOf, machinedOf, notMachined, pickable, sceneOf } from "./scene";
import { inDrawing, originOf, tableItems } from "./table";
import { path, rectangle } from "./testing";
import { toPixels } from "./window";

const square = rectangle(1, 0, 0, 100, 100);
const turned = path(1, [0, 0, 0, 0, 100, 0, 100, 100, 0, 100, 0, 0], { closed: true });
const nothing = Object.fromEntries(
  Object.keys(optionWords).map((key) => [key, false]),
) as unknown as ViewOptions;

const showing = (...wanted: ViewOption[]): ViewOptions => ({
  ...nothing,
  ...Object.fromEntries(wanted.map((option) => [option, true])),
});

interface Given {
  readonly shapes?: readonly Shape[];
  readonly groups?: readonly Partial<GroupState>[];
  readonly paths?: Partial<ToolPaths>;
}

function sceneWith(options: ViewOptions, { shapes = [square], groups = [], paths = {} }: Given) {
  const drawing = { groups: groups.map((group) => ({ on: true, offset: 0, ...group })) };
  const made = { revision: 1, paths: [], smoothed: [], filtered: [], notes: [], ...paths };
  const loaded = { ...loadedOf({ revision: 1, shapes: [] }), shapes };
  return sceneOf(loaded, drawing as never, machinedOf(made), options);
}

const picture = (options: ViewOptions, given: Given = {}) => pictureOf(sceneWith(options, given));

const marks = <K extends Mark["kind"]>(kind: K, options: ViewOptions, given: Given = {}) =>
  picture(options, given).marks.filter(
    (mark): mark is Extract<Mark, { kind: K }> => mark.kind === kind,
  );

/** Checks that an ink has a colour in every theme. */
const inkIs = (token: string | undefined, colour: string) => {
  const colours = coloursOf(token ?? "");
  expect(colours.length).toBeGreaterThan(1);
  expect(new Set(colours)).toEqual(new Set([colour]));
};

describe("the sheet", () => {
  it("pro_display_topview: x to the right, y upwards, flat and 3D shapes alike", () => {
    const [window, size] = [
      { middle: place(0, 0), mmPerPixel: 1 },
      { width: 400, height: 400 },
    ];
    const pixel = (x: number, y: number) => toPixels(window, size, place(x, y));
    expect(pixel(100, 0).x).toBeGreaterThan(pixel(0, 0).x);
    expect(pixel(0, 100).y).toBeLessThan(pixel(0, 0).y);
    const space = shapeOf({ ...raw([0, 0, 0, 100, 0, 0]), z: [0, -5] });
    const flat = shapeOf(raw([0, 0, 0, 100, 0, 0]));
    expect(space.segments).toEqual(flat.segments);
  });

  it("pro_display_bounds_2d: the smallest rectangle, arcs counted", () => {
    const { min, max } = boxOfShapes([path(1, [0, 0, 0.5, 100, 0, 0])]);
    expect([min.x, max.x, min.y, max.y].map((n) => Math.round(n * 1e9) / 1e9)).toEqual([
      0, 100, -25, 0,
    ]);
  });

  it("pro_display_bbox_green: the bounds are green and dashed, and follow every change", () => {
    const [bounds] = marks("bbox", nothing);
    expect(bounds).toMatchObject({ dash: true, box: { min: place(0, 0), max: place(100, 100) } });
    inkIs(bounds?.ink, "green");
    const [moved] = marks("bbox", nothing, { shapes: [rectangle(1, 10, 0, 60, 30)] });
    expect(moved?.box).toEqual({ min: place(10, 0), max: place(60, 30) });
    expect(marks("bbox", nothing, { shapes: [] })).toEqual([]);
  });

  it("pro_display_start_indicator: yellow, at the start, in the direction of travel", () => {
    const [start] = marks("start", showing("starts"));
    expect(start).toMatchObject({ at: place(0, 0), angle: 0 });
    inkIs(start?.ink, "yellow");
    expect(marks("start", showing("starts"), { shapes: [turned] })[0]?.angle).toBe(90);
  });

  it("pro_display_starts: only when wanted, with the side of the tool", () => {
    expect(marks("start", nothing)).toEqual([]);
    const side = (offset: number) =>
      marks("start", showing("starts"), { groups: [{ name: "black", offset: mm(offset) }] })[0]
        ?.side;
    expect([side(3), side(0), side(-3)]).toEqual(["right", "right", "left"]);
  });

  it("pro_display_vertices: black crosses, one a vertex", () => {
    const found = marks("vertex", showing("vertices"));
    expect(found.map(({ at }) => at)).toEqual(square.vertices);
    expect(coloursOf(found[0]?.ink ?? "")[0]).toBe("black");
    expect(marks("vertex", nothing)).toEqual([]);
  });

  it("pro_display_filtered: blue crosses at the vertices that are left out", () => {
    const given = { paths: { filtered: [0.01, 0] } };
    const found = marks("filtered", showing("filtered"), given);
    expect(found.map(({ at }) => at)).toEqual([place(0.01, 0)]);
    inkIs(found[0]?.ink, "blue");
    expect(marks("filtered", nothing, given)).toEqual([]);
  });

  it("pro_display_smoothed: the curves that are machined, yellow", () => {
    const given = { paths: { smoothed: [raw([50, 0, 1, -50, 0, 1])] } };
    const of = (options: ViewOptions, which: Given) =>
      picture(options, which).strokes.filter(({ kind }) => kind === "smoothed");
    const [curve] = of(showing("smoothed"), given);
    inkIs(curve?.ink, "yellow");
    expect(of(nothing, given)).toEqual([]);
    expect(of(showing("smoothed"), {})).toEqual([]);
  });

  it("pro_display_off_dashed: shapes of groups that are off are dashed, in their colours", () => {
    const [stroke] = picture(showing("offDashed"), off).strokes;
    expect(stroke).toMatchObject({ dash: true, ink: "--draw-anticlockwise" });
  });

  it("pro_display_off_hidden: or they are not there, and not to be picked", () => {
    const scene = sceneWith(nothing, off);
    expect(pictureOf(scene).strokes).toEqual([]);
    expect(scene.box).toEqual(square.box);
    expect(shapesNear(pickable(scene), place(50, 0), 5)).toEqual([]);
    const shown = pickable(sceneWith(showing("offDashed"), off));
    expect(shapesNear(shown, place(50, 0), 5)).toHaveLength(1);
  });

  it("pro_display_rough: the rough path besides the final one", () => {
    const cut = (pass: "rough" | "final", by: number) => ({
      ...raw([-by, -by, 0, 100 + by, -by, 0, 100 + by, 100 + by, 0, -by, 100 + by, 0]),
      pass,
    });
    const given = { paths: { paths: [cut("rough", 3.5), cut("final", 3)] } };
    const offsets = (options: ViewOptions) =>
      picture(options, given)
        .strokes.filter(({ kind }) => kind === "rough" || kind === "path")
        .map(({ shape }) => -shape.box.min.x);
    expect(offsets(showing("toolPaths", "rough"))).toEqual([3.5, 3]);
    expect(offsets(showing("toolPaths"))).toEqual([3]);
  });
});

const off: Given = { groups: [{ name: "black", on: false }] };

const raw = (points: number[]) => ({
  number: 1,
  group: "black",
  closed: points.length > 6,
  points,
  z: null,
  pause: false,
});

describe("the job on the machine", () => {
  const on = { reach: [mm(2500), mm(1250)] as [Mm, Mm], origin: place(300, 200), tool: null };

  it("pro_display_machbounds: bounds, home, origin and finish in the machine's coordinates", () => {
    const items = tableItems({ ...on, finish: place(25, 20) });
    expect(items).toEqual([
      { kind: "bounds", box: { min: place(0, 0), max: place(2500, 1250) } },
      { kind: "home", at: place(0, 0) },
      { kind: "origin", at: place(300, 200) },
      { kind: "finish", at: place(325, 220) },
    ]);
    expect(inDrawing(items, on.origin)[2]).toEqual({ kind: "origin", at: place(0, 0) });
  });

  it("finds the origin where the working zero is", () => {
    const { motion } = firstSnapshot;
    const at = { ...motion.at, machine: [310, 220, 0, 0, 0, 0], working: [10, 20, 0, 0, 0, 0] };
    expect(originOf({ ...motion, at: at as typeof motion.at })).toEqual(place(300, 200));
  });

  it("has no bounds where the machine has none", () => {
    const items = tableItems({ ...on, reach: [mm(0), mm(0)], finish: place(0, 0) });
    expect(items.map(({ kind }) => kind)).toEqual(["home", "origin", "finish"]);
    expect(notMachined.paths).toEqual([]);
  });
});
