/** Rows of the ledger about editing a drawing, as a hand does it: with the mouse on the sheet, and typed places. */

import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { openSheet, type Sheet } from "./sheet";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;
let sheet: Sheet;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  sheet = await openSheet(workshop);
});
afterAll(() => workshop?.close());
beforeEach(() => sheet.page.keyboard.press("Escape"));

/** Vertices without their bulges. */
const corners = async (n = 0): Promise<number[][]> => {
  const points = (await sheet.shapes())[n]?.points ?? [];
  return Array.from({ length: points.length / 3 }, (_, i) => [...points.slice(3 * i, 3 * i + 2)]);
};

/** Left ends in cutting order. */
const order = async () =>
  (await sheet.shapes()).map(({ points }) => Math.min(...points.filter((_, i) => i % 3 === 0)));

const square = "rect 0,0 100,100";
/** A point that keeps the corner of the sheet with the buttons of the view free of what is clicked. */
const room = "point 200,140";

const picked = (count: number) => sheet.page.getByText(`(${count} picked)`).waitFor();

it("pro_edit_delvert: picked vertices go at the right click, in flat shapes only", async () => {
  await sheet.given(
    `line 0,0 50,-10 100,0 100,100 0,100 close; line 150,0 170,50 150,100; ${room}`,
  );
  await sheet.tool("Delete vertex");
  await sheet.click([98, 100]);
  await sheet.click([50, -10]);
  await sheet.click([170, 50]);
  await sheet.click([0, 100]);
  await picked(4);
  // A vertex that is picked again stays; nothing is gone yet, and Esc gives the picks up.
  await sheet.click([0, 100]);
  await picked(3);
  expect((await corners()).length).toBe(5);
  await sheet.page.keyboard.press("Escape");
  await sheet.tool("Delete vertex");
  await picked(0);
  for (const at of [
    [98, 100],
    [50, -10],
    [170, 50],
  ] as const)
    await sheet.click(at);
  await picked(3);
  await sheet.click([50, 50], "right");
  const left = [
    [0, 0],
    [100, 0],
    [0, 100],
  ];
  await expect.poll(() => corners()).toEqual(left);
  const straight = [
    [150, 0],
    [150, 100],
  ];
  expect(await corners(1)).toEqual(straight);
  // It goes on with the next ones. One change was made, and comes back as one.
  await picked(0);
  await sheet.page.keyboard.press("Escape");
  await sheet.page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(async () => (await corners()).length).toBe(5);
  expect((await corners(1)).length).toBe(3);
});

it("pro_edit_delvert: a vertex of a 3D shape stays, and the reason is told", async () => {
  await sheet.given("line3d 0,0,0 50,0,-1 100,60,-2");
  await sheet.tool("Delete vertex");
  await sheet.click([49, 0]);
  await sheet.click([49, 0], "right");
  await sheet.page.getByText("flat shapes only").first().waitFor();
  expect((await corners()).length).toBe(3);
});

it("pro_edit_stretch: a window takes vertices, from a base place to another", async () => {
  await sheet.given(`${square}; point 160,-20`);
  await sheet.tool("Stretch");
  await sheet.click([50, 0]);
  await sheet.click([50, 0], "right");
  await sheet.page.mouse.move(...sheet.pixel([90, -10]));
  await sheet.page.mouse.down();
  await sheet.page.mouse.move(...sheet.pixel([100, 50]));
  await sheet.page.mouse.move(...sheet.pixel([110, 110]));
  await sheet.page.mouse.up();
  await picked(2);
  await sheet.click([50, 50], "right");
  await sheet.snap([99, 1]);
  await sheet.type("@20mm,0");
  const wide = [
    [0, 0],
    [120, 0],
    [120, 100],
    [0, 100],
  ];
  await expect.poll(() => corners()).toEqual(wide);
});

it("pro_edit_stretch: vertices that are picked one by one move, their neighbours stay", async () => {
  await sheet.given(`${square}; rect 100,100 150,150; point 160,-20`);
  await sheet.tool("Stretch");
  await sheet.click([50, 0]);
  await sheet.click([50, 0], "right");
  await sheet.click([1, 99]);
  await sheet.click([99, 1]);
  await sheet.click([99, 99]);
  await picked(3);
  await sheet.click([99, 99]);
  await picked(2);
  await sheet.click([50, 50], "right");
  await sheet.snap([99, 1]);
  await sheet.type("@0,-10mm");
  const pulled = [
    [0, 0],
    [100, -10],
    [100, 100],
    [0, 90],
  ];
  await expect.poll(() => corners()).toEqual(pulled);
  expect((await corners(1))[0], "a shape that was not picked").toEqual([100, 100]);
});

it("pro_edit_rotate_abs: a line that was picked gets an angle, typed or by the mouse", async () => {
  await sheet.given(`line 0,0 100,100; point -50,0; ${room}`);
  await sheet.tool("Rotate to");
  await sheet.click([60, 60]);
  await sheet.click([60, 60], "right");
  await sheet.snap([1, 1]);
  await sheet.snap([99, 99]);
  await sheet.type("90");
  await expect
    .poll(() => corners())
    .toEqual([
      [0, 0],
      [0, 141.421],
    ]);
  // It is selected still. By the mouse: towards the point it lies at 180°.
  await sheet.tool("Rotate to");
  await sheet.snap([1, 1]);
  await sheet.type("0,10mm");
  await sheet.snap([-49, 0]);
  await expect
    .poll(() => corners())
    .toEqual([
      [0, 0],
      [-141.421, 0],
    ]);
});

it("pro_edit_scale_ref: a line that was picked gets a length, typed or by the mouse", async () => {
  await sheet.given("line 0,0 50,0 50,20; point 0,100");
  const scaled = (factor: number) => [
    [0, 0],
    [50 * factor, 0],
    [50 * factor, 20 * factor],
  ];
  await sheet.tool("Scale to");
  await sheet.click([25, 0]);
  await sheet.click([25, 0], "right");
  await sheet.snap([1, 0]);
  await sheet.snap([49, 1]);
  await sheet.type("75mm");
  await expect.poll(() => corners()).toEqual(scaled(1.5));
  // It is selected still. As long as it is to the point, from the start of the base line.
  await sheet.tool("Scale to");
  await sheet.snap([1, 0]);
  await sheet.snap([74, 1]);
  await sheet.snap([0, 99]);
  await expect.poll(() => corners()).toEqual(scaled(2));
});

/** A and C are black, B and D red; each begins where its place in the alphabet says. */
const four = [0, 100, 200, 300].map((x) => `rect ${x},0 ${x + 50},50`).join("; ");

it("pro_sequence_group: a shape of each group is picked, groups follow in that order", async () => {
  await sheet.given(`${four}; select 2,4; group red`);
  await sheet.tool("Order of layers");
  await sheet.click([300, 25]);
  await sheet.click([0, 25]);
  await sheet.click([0, 25], "right");
  await expect.poll(order).toEqual([100, 300, 0, 200]);
});

it("pro_sequence_level: the order within one shape is picked, and nothing else changes", async () => {
  const holes = "rect 10,10 30,30; rect 40,10 60,30; rect 70,10 90,30; rect 0,0 100,100";
  await sheet.given(`${holes}; rect 210,10 230,30; rect 240,10 260,30; rect 200,0 300,100`);
  expect(await order()).toEqual([10, 40, 70, 0, 210, 240, 200]);
  await sheet.tool("Order of a level");
  for (const x of [70, 10, 40]) await sheet.click([x, 20]);
  await sheet.click([150, 50], "right");
  await expect.poll(order).toEqual([70, 10, 40, 0, 210, 240, 200]);
  // Whole plates are a level too: each goes with its holes.
  await sheet.tool("Order of a level");
  for (const x of [200, 0]) await sheet.click([x, 60]);
  await sheet.click([150, 50], "right");
  await expect.poll(order).toEqual([210, 240, 200, 70, 10, 40, 0]);
});

it("pro_clipboard_paste_abs: what was copied stands from a place as it stood from its origin", async () => {
  await sheet.given("rect 30,40 80,60");
  await sheet.tool("To clipboard");
  await sheet.click([50, 40]);
  await sheet.click([50, 40], "right");
  for (const [typed, x, y] of [
    ["100mm,0", 130, 40],
    ["0,0", 30, 40],
  ] as const) {
    const before = (await sheet.shapes()).length;
    await sheet.tool("Paste absolute");
    await sheet.type(typed);
    await expect.poll(async () => (await sheet.shapes()).length).toBe(before + 1);
    const pasted = await corners(before);
    expect(pasted).toEqual([
      [x, y],
      [x + 50, y],
      [x + 50, y + 20],
      [x, y + 20],
    ]);
  }
});

it("pro_group_copy: a copy in another group lies on the shape it came from, and is cut last", async () => {
  await sheet.given(`${square}; point 1,1`);
  await sheet.click([100, 50]);
  await sheet.tool("copy: the selection into red");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(3);
  const [first, , last] = await sheet.shapes();
  expect([first?.group, last?.group]).toEqual(["black", "red"]);
  expect(last?.points).toEqual(first?.points);
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
