/** What the manual says of the mouse at the drawing: clicks, drags and keys with it, in a window of known scale. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import type { ShapeList } from "../../src/wire/messages";
import { openWorkshop, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

/** A pixel is half a millimetre, and this place is in the middle of the sheet. */
const scale = 2;
const middle = [60, 50] as const;
/** What a fit shows beyond the drawing. */
const expansion = 1.05;

const does = async (clauses: string) => {
  const op = { op: "do", clauses };
  // The page asks for shapes that are new; those that were only chosen it has.
  const heard = page
    .waitForResponse((one) => one.url().includes("/api/drawing/shapes"), { timeout: 700 })
    .then((one) => one.finished())
    .catch(() => null);
  const answer = await page.request.post(`${workshop.address}/api/do/draw`, { data: { op } });
  expect(await answer.text()).toContain('"problem":null');
  await heard;
};

const sheet = async () => {
  const box = await page.getByRole("application", { name: "Shapes of the drawing" }).boundingBox();
  if (!box) throw new Error("there is no sheet");
  return box;
};

/** The pixel of a place of the drawing. */
async function pixel(x: number, y: number): Promise<[number, number]> {
  const { x: left, y: top, width, height } = await sheet();
  return [left + width / 2 + (x - middle[0]) * scale, top + height / 2 - (y - middle[1]) * scale];
}

const at = async (x: number, y: number) => page.mouse.move(...(await pixel(x, y)));

async function click(x: number, y: number, button: "left" | "right" = "left"): Promise<void> {
  await page.mouse.click(...(await pixel(x, y)), { button });
}

/** From one place to another with the left button held. */
async function drag(from: [number, number], to: [number, number]): Promise<void> {
  await at(...from);
  await page.mouse.down();
  await at((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await at(...to);
}

const tool = (name: string) => page.getByRole("button", { name, exact: true }).click();

async function listed(): Promise<ShapeList["shapes"]> {
  const answer = await page.request.get(`${workshop.address}/api/drawing/shapes`);
  return ((await answer.json()) as ShapeList).shapes;
}

/** Waits for a shape whose numbers, three a vertex, are these to within a pixel. */
async function shape(number: number, points: readonly number[], closed: boolean): Promise<void> {
  const found = async () => (await listed()).find((one) => one.number === number);
  await until(
    async () => {
      const now = await found();
      const near = (value: number, n: number) => Math.abs(value - (points[n] ?? 1e9)) <= 0.5;
      return now?.points.length === points.length && now.points.every(near);
    },
    `shape ${number} is ${points}, not ${JSON.stringify(await found())}`,
  );
  expect((await found())?.closed).toBe(closed);
}

const count = async (wanted: number) =>
  until(async () => (await listed()).length === wanted, `${wanted} shapes`);

const selection = async () => (await stateOf(workshop)).drawing?.selection ?? [];

const selected = async (wanted: readonly number[]) =>
  until(async () => String(await selection()) === String(wanted), `selected: ${wanted}`);

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  page = await workshop.page();
  await page.goto(`${workshop.address}/draw`);
  await sheet();
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  for (let n = 0; n < 4; n += 1) await page.keyboard.press("Escape");
  const { width, height } = await sheet();
  const [wide, high] = [width, height].map((size) => size / scale / expansion) as [number, number];
  const corner = (sign: number) =>
    `${middle[0] + (sign * wide) / 2},${middle[1] + (sign * high) / 2}`;
  await page.request.post(`${workshop.address}/api/do/draw`, { data: { op: { op: "new" } } });
  await does(`point ${corner(-1)}; point ${corner(1)}`);
  await page.locator(".facts dd", { hasText: /^2$/ }).first().waitFor();
  await page.locator('[data-key="a"]').click();
  await does("select all; erase");
  await count(0);
});

const square = "rect 0,0 100,100";

it("pro_select_lmb_point, pro_draw_point: a click makes a point where it is", async () => {
  await tool("Point");
  await click(12, 34);
  await shape(1, [12, 34, 0], false);
});

it("pro_draw_circle: a click for the centre, one for the radius", async () => {
  await tool("Circle");
  await click(50, 50);
  await click(75, 50);
  await shape(1, [75, 50, 1, 25, 50, 1], true);
});

it("pro_draw_rect: two clicks at opposite corners, the first is the start", async () => {
  await tool("Rectangle");
  await click(10, 10);
  await click(60, 40);
  await shape(1, [10, 10, 0, 60, 10, 0, 60, 40, 0, 10, 40, 0], true);
});

it("pro_draw_line: click after click, the right button ends it", async () => {
  await tool("Line");
  await click(0, 0);
  await click(10, 0);
  await click(10, 10);
  await click(90, 90, "right");
  await shape(1, [0, 0, 0, 10, 0, 0, 10, 10, 0], false);
});

it("pro_draw_line_type: points are clicked or typed, as one likes", async () => {
  await tool("Line");
  await click(0, 0);
  await page.keyboard.type("t");
  for (const text of ["10mm,0mm", "10mm,10mm"]) {
    const entry = page.getByPlaceholder("x,y");
    if ((await entry.count()) === 0) await page.keyboard.type("t");
    await entry.fill(text);
    await page.keyboard.press("Enter");
  }
  if ((await page.getByPlaceholder("x,y").count()) > 0) await page.keyboard.press("Escape");
  await click(90, 90, "right");
  await shape(1, [0, 0, 0, 10, 0, 0, 10, 10, 0], false);
});

it("pro_draw_poly_open_rmb: the right button ends a line of two points, and drops one of one", async () => {
  await tool("Line");
  await click(20, 20);
  await click(90, 90, "right");
  await tool("Line");
  await click(0, 0);
  await click(10, 0);
  await click(90, 90, "right");
  await shape(1, [0, 0, 0, 10, 0, 0], false);
  await count(1);
});

it("pro_select_region, pro_select_window: from left to right only what lies inside is selected", async () => {
  await does("rect 0,0 10,10; rect 40,0 60,10; select none");
  await drag([-4, -4], [50, 30]);
  await page.mouse.up();
  await selected([1]);
});

it("pro_select_crossing: from right to left also what the region touches, not what surrounds it", async () => {
  await does("rect 0,0 10,10; rect 40,0 60,10; rect -20,-20 100,90; select none");
  await drag([50, 30], [-4, -4]);
  await page.mouse.up();
  await selected([1, 2]);
});

it("pro_select_radius, pro_options_radius: a click takes a shape up to the radius of picking, no farther", async () => {
  await does(`${square}; select none`);
  // Eight pixels are four millimetres.
  await click(104.5, 50);
  await selected([]);
  await click(103.5, 50);
  await selected([1]);
});

const buttons = () =>
  page
    .locator(".chooser button")
    .evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));

it("pro_select_chooser, pro_select_chooser_order: shapes under a click are chosen by colour, in their order", async () => {
  await does(`${square}; ${square}; select 2; group red; select none`);
  await click(100, 50);
  await page.locator(".chooser").waitFor();
  expect(await buttons()).toEqual(["Shape 1, group black", "Shape 2, group red"]);
  expect(await selection()).toEqual([]);
  await page.locator(".chooser button").nth(1).click();
  await selected([2]);
  await does("sequence reverse; select none");
  await click(100, 50);
  await page.locator(".chooser").waitFor();
  expect(await buttons()).toEqual(["Shape 1, group red", "Shape 2, group black"]);
});

it("pro_select_chooser_mark: what is selected already is marked", async () => {
  await does(`${square}; ${square}; select 2; group red; select 1`);
  await click(100, 50);
  await page.locator(".chooser").waitFor();
  expect(await buttons()).toEqual(["Shape 1, group black, selected", "Shape 2, group red"]);
  expect(await page.locator(".chooser button").first().getAttribute("class")).toContain("marked");
});

const prompt = (text: string) => page.getByText(text).first().waitFor();

it("pro_select_rmb_finish: the right button ends picking shapes, and the tool goes on", async () => {
  await does("rect 0,0 20,20; rect 40,0 60,20; select none");
  await tool("Move");
  await click(10, 0);
  await click(50, 0);
  await click(90, 90, "right");
  await click(0, 0);
  await prompt("Where it goes");
  await click(0, 30);
  await shape(2, [40, 30, 0, 60, 30, 0, 60, 50, 0, 40, 50, 0], true);
});

it("pro_select_rmb_cancel: the right button at the last step leaves everything where it was", async () => {
  await does("rect 0,0 20,20; select 1");
  await tool("Move");
  await click(0, 0);
  await prompt("Where it goes");
  await at(50, 50);
  await click(50, 50, "right");
  await shape(1, [0, 0, 0, 20, 0, 0, 20, 20, 0, 0, 20, 0], true);
});

it("pro_select_rmb_repeat: the right button begins the last tool again", async () => {
  await does("rect 0,0 20,20; select 1");
  await tool("Move");
  await click(0, 0);
  await click(0, 10);
  await shape(1, [0, 10, 0, 20, 10, 0, 20, 30, 0, 0, 30, 0], true);
  await page.keyboard.press("Escape");
  const pressed = page.locator('.tool-button[aria-pressed="true"]');
  expect(await pressed.count()).toBe(0);
  await click(90, 90, "right");
  await page.locator('.tool-button[aria-pressed="true"]', { hasText: "Move" }).waitFor();
});

/** Draws a line whose start is picked with a snap and a pointer near it; where it starts. */
async function snapped(key: string, near: [number, number]): Promise<[number, number]> {
  const before = (await listed()).length;
  await tool("Line");
  await at(...near);
  await page.keyboard.press(key);
  await click(...near);
  await page.keyboard.press("q");
  await click(30, 90);
  await click(90, 90, "right");
  await count(before + 1);
  const [x = Number.NaN, y = Number.NaN] = (await listed()).at(-1)?.points ?? [];
  return [x, y];
}

it("pro_snap_vertex: V takes the vertex near the mouse exactly", async () => {
  await does(`${square}; select none`);
  expect(await snapped("v", [98.5, 99])).toEqual([100, 100]);
});

it("pro_snap_centre: C takes the centre of the arc under the mouse", async () => {
  await does("line 40,40,0.5 50,40; select none");
  expect(await snapped("c", [45, 37.5])).toEqual([45, 43.75]);
});

it("pro_snap_midpoint: M takes the middle of a line, from its middle three fifths", async () => {
  await does("line 0,0 100,0; select none");
  expect(await snapped("m", [25, 1])).toEqual([50, 0]);
});

it("pro_snap_intersection: I takes the place where two lines cross", async () => {
  await does("line 0,0 100,100; line 0,100 100,0; select none");
  expect(await snapped("i", [51.5, 51])).toEqual([50, 50]);
});

it("pro_snap_nearest: N takes the nearest place of a shape", async () => {
  await does("line 0,0 100,0; select none");
  const [x, y] = await snapped("n", [40, 1.5]);
  expect(y).toBe(0);
  expect(Math.abs(x - 40)).toBeLessThanOrEqual(0.5);
});

it("pro_snap_none, pro_snap_oneshot: Q takes a snap back, and one pick uses it up", async () => {
  await does(`${square}; select none`);
  await tool("Line");
  await page.keyboard.press("v");
  await click(98, 99);
  // Without a key the second one is where the mouse is; and V is taken back by Q for the third.
  await click(98, 2);
  await page.keyboard.press("v");
  await page.keyboard.press("q");
  await click(2, 2);
  await click(60, 60, "right");
  await shape(2, [100, 100, 0, 98, 2, 0, 2, 2, 0], false);
  expect((await listed())[1]?.points.slice(0, 2)).toEqual([100, 100]);
});

it("pro_snap_ortho: G keeps the second place level or plumb with the first", async () => {
  await does("rect 10,20 30,40; select 1");
  await tool("Move");
  await click(10, 20);
  await page.keyboard.press("g");
  await click(60, 35);
  await shape(1, [60, 20, 0, 80, 20, 0, 80, 40, 0, 60, 40, 0], true);
});

it("pro_edit_bulge_drag: the middle of a side is taken and drawn out into an arc", async () => {
  await does("line 0,20 100,20; select 1");
  await tool("Bulge");
  await click(50, 20);
  await click(50, -5);
  await until(async () => {
    const bulge = (await listed())[0]?.points[2] ?? 0;
    return Math.abs(bulge - 0.5) < 0.03;
  }, "a bulge of a half");
  expect(workshop.mistakes).toEqual([]);
});
