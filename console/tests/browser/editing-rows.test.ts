/** Rows of the ledger about editing a drawing, as a hand does it: with the mouse on the sheet, and typed places. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

type Point = readonly [x: number, y: number];

/** Pixels of the page for a place of the drawing, millimetres. */
let pixel: (at: Point) => Point;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  page = await workshop.page();
  await page.goto(`${workshop.address}/draw`);
});
afterAll(() => workshop?.close());
beforeEach(() => page.keyboard.press("Escape"));

const post = async (op: object) => {
  const answer = await page.request.post(`${workshop.address}/api/do/draw`, { data: { op } });
  expect(await answer.text()).toContain('"problem":null');
};

interface Listed {
  readonly number: number;
  readonly group: string;
  readonly points: readonly number[];
}

/** What the server has, in cutting order, to a thousandth of a millimetre. */
async function shapes(): Promise<Listed[]> {
  const answer = await page.request.get(`${workshop.address}/api/drawing/shapes`);
  const list: { shapes: Listed[] } = await answer.json();
  const round = (value: number) => Math.round(value * 1000) / 1000 + 0;
  return list.shapes.map((shape) => ({ ...shape, points: shape.points.map(round) }));
}

/** Vertices without their bulges. */
const corners = async (n = 0): Promise<number[][]> => {
  const points = (await shapes())[n]?.points ?? [];
  return Array.from({ length: points.length / 3 }, (_, i) => [...points.slice(3 * i, 3 * i + 2)]);
};

/** Left ends in cutting order. */
const order = async () =>
  (await shapes()).map(({ points }) => Math.min(...points.filter((_, i) => i % 3 === 0)));

/** A drawing with all of it in sight, and where its places are on the page. */
async function given(clauses: string): Promise<void> {
  const fact = page.locator(".facts div").filter({ hasText: "Shapes" }).locator("dd");
  const shown = (count: number) => expect.poll(() => fact.textContent()).toBe(String(count));
  await post({ op: "new" });
  await shown(0);
  await post({ op: "do", clauses: `${clauses}; select none` });
  await shown((await shapes()).length);
  await page.locator('[data-key="a"]').click();
  const sheet = await page.getByRole("application").boundingBox();
  if (!sheet) throw new Error("there is no sheet");
  const low: Point = [sheet.x + 40, sheet.y + sheet.height - 40];
  const high: Point = [sheet.x + sheet.width - 40, sheet.y + 40];
  const [a, b] = [await placeAt(low), await placeAt(high)];
  const along = (k: 0 | 1, at: Point) =>
    low[k] + ((at[k] - a[k]) * (high[k] - low[k])) / (b[k] - a[k]);
  pixel = (at) => [along(0, at), along(1, at)];
}

/** What the line below the drawing tells of the mouse, millimetres. */
async function placeAt([x, y]: Point): Promise<Point> {
  const told = page.locator(".sheet-status-place");
  await page.mouse.move(x - 3, y);
  const before = await told.textContent();
  await page.mouse.move(x, y);
  await expect.poll(() => told.textContent()).not.toBe(before);
  const [across = 0, up = 0] = ((await told.textContent()) ?? "").split(/[, ]+/).map(Number);
  return [across * 25.4, up * 25.4];
}

const tool = (name: string) => page.getByRole("button", { name, exact: true }).click();

async function click(at: Point, button: "left" | "right" = "left"): Promise<void> {
  await page.mouse.click(...pixel(at), { button });
}

/** Clicks the vertex that is nearest, exactly. */
async function snap(at: Point): Promise<void> {
  await page.mouse.move(...pixel(at));
  await page.keyboard.press("v");
  await click(at);
}

/** Types a place or a number for what is asked. */
async function type(text: string): Promise<void> {
  await page.keyboard.press("t");
  await page.locator("#drawing-entry").fill(text);
  await page.keyboard.press("Enter");
}

const square = "rect 0,0 100,100";
/** A point that keeps the corner of the sheet with the buttons of the view free of what is clicked. */
const room = "point 200,140";

const picked = (count: number) => page.getByText(`(${count} picked)`).waitFor();

it("pro_edit_delvert: picked vertices go at the right click, in flat shapes only", async () => {
  await given(`line 0,0 50,-10 100,0 100,100 0,100 close; line 150,0 170,50 150,100; ${room}`);
  await tool("Delete vertex");
  await click([98, 100]);
  await click([50, -10]);
  await click([170, 50]);
  await click([0, 100]);
  await picked(4);
  // A vertex that is picked again stays; nothing is gone yet, and Esc gives the picks up.
  await click([0, 100]);
  await picked(3);
  expect((await corners()).length).toBe(5);
  await page.keyboard.press("Escape");
  await tool("Delete vertex");
  await picked(0);
  for (const at of [
    [98, 100],
    [50, -10],
    [170, 50],
  ] as const)
    await click(at);
  await picked(3);
  await click([50, 50], "right");
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
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(async () => (await corners()).length).toBe(5);
  expect((await corners(1)).length).toBe(3);
});

it("pro_edit_delvert: a vertex of a 3D shape stays, and the reason is told", async () => {
  await given("line3d 0,0,0 50,0,-1 100,60,-2");
  await tool("Delete vertex");
  await click([49, 0]);
  await click([49, 0], "right");
  await page.getByText("flat shapes only").first().waitFor();
  expect((await corners()).length).toBe(3);
});

it("pro_edit_stretch: a window takes vertices, from a base place to another", async () => {
  await given(`${square}; point 160,-20`);
  await tool("Stretch");
  await click([50, 0]);
  await click([50, 0], "right");
  await page.mouse.move(...pixel([90, -10]));
  await page.mouse.down();
  await page.mouse.move(...pixel([100, 50]));
  await page.mouse.move(...pixel([110, 110]));
  await page.mouse.up();
  await picked(2);
  await click([50, 50], "right");
  await snap([99, 1]);
  await type("@20mm,0");
  const wide = [
    [0, 0],
    [120, 0],
    [120, 100],
    [0, 100],
  ];
  await expect.poll(() => corners()).toEqual(wide);
});

it("pro_edit_stretch: vertices that are picked one by one move, their neighbours stay", async () => {
  await given(`${square}; rect 100,100 150,150; point 160,-20`);
  await tool("Stretch");
  await click([50, 0]);
  await click([50, 0], "right");
  await click([1, 99]);
  await click([99, 1]);
  await click([99, 99]);
  await picked(3);
  await click([99, 99]);
  await picked(2);
  await click([50, 50], "right");
  await snap([99, 1]);
  await type("@0,-10mm");
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
  await given(`line 0,0 100,100; point -50,0; ${room}`);
  await tool("Rotate to");
  await click([60, 60]);
  await click([60, 60], "right");
  await snap([1, 1]);
  await snap([99, 99]);
  await type("90");
  await expect
    .poll(() => corners())
    .toEqual([
      [0, 0],
      [0, 141.421],
    ]);
  // It is selected still. By the mouse: towards the point it lies at 180°.
  await tool("Rotate to");
  await snap([1, 1]);
  await type("0,10mm");
  await snap([-49, 0]);
  await expect
    .poll(() => corners())
    .toEqual([
      [0, 0],
      [-141.421, 0],
    ]);
});

it("pro_edit_scale_ref: a line that was picked gets a length, typed or by the mouse", async () => {
  await given("line 0,0 50,0 50,20; point 0,100");
  const scaled = (factor: number) => [
    [0, 0],
    [50 * factor, 0],
    [50 * factor, 20 * factor],
  ];
  await tool("Scale to");
  await click([25, 0]);
  await click([25, 0], "right");
  await snap([1, 0]);
  await snap([49, 1]);
  await type("75mm");
  await expect.poll(() => corners()).toEqual(scaled(1.5));
  // It is selected still. As long as it is to the point, from the start of the base line.
  await tool("Scale to");
  await snap([1, 0]);
  await snap([74, 1]);
  await snap([0, 99]);
  await expect.poll(() => corners()).toEqual(scaled(2));
});

/** A and C are black, B and D red; each begins where its place in the alphabet says. */
const four = [0, 100, 200, 300].map((x) => `rect ${x},0 ${x + 50},50`).join("; ");

it("pro_sequence_group: a shape of each group is picked, groups follow in that order", async () => {
  await given(`${four}; select 2,4; group red`);
  await tool("Order of groups");
  await click([300, 25]);
  await click([0, 25]);
  await click([0, 25], "right");
  await expect.poll(order).toEqual([100, 300, 0, 200]);
});

it("pro_sequence_level: the order within one shape is picked, and nothing else changes", async () => {
  const holes = "rect 10,10 30,30; rect 40,10 60,30; rect 70,10 90,30; rect 0,0 100,100";
  await given(`${holes}; rect 210,10 230,30; rect 240,10 260,30; rect 200,0 300,100`);
  expect(await order()).toEqual([10, 40, 70, 0, 210, 240, 200]);
  await tool("Order of a level");
  for (const x of [70, 10, 40]) await click([x, 20]);
  await click([150, 50], "right");
  await expect.poll(order).toEqual([70, 10, 40, 0, 210, 240, 200]);
  // Whole plates are a level too: each goes with its holes.
  await tool("Order of a level");
  for (const x of [200, 0]) await click([x, 60]);
  await click([150, 50], "right");
  await expect.poll(order).toEqual([210, 240, 200, 70, 10, 40, 0]);
});

it("pro_clipboard_paste_abs: what was copied stands from a place as it stood from its origin", async () => {
  await given("rect 30,40 80,60");
  await tool("To clipboard");
  await click([50, 40]);
  await click([50, 40], "right");
  for (const [typed, x, y] of [
    ["100mm,0", 130, 40],
    ["0,0", 30, 40],
  ] as const) {
    const before = (await shapes()).length;
    await tool("Paste absolute");
    await type(typed);
    await expect.poll(async () => (await shapes()).length).toBe(before + 1);
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
  await given(`${square}; point 1,1`);
  await click([100, 50]);
  await tool("copy: the selection into red");
  await expect.poll(async () => (await shapes()).length).toBe(3);
  const [first, , last] = await shapes();
  expect([first?.group, last?.group]).toEqual(["black", "red"]);
  expect(last?.points).toEqual(first?.points);
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
