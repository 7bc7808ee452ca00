/** Rows of the ledger about picking with the mouse, and snaps. A pixel is a millimetre unless a test says otherwise. */

import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { type Painted, painted } from "./pixels";
import { openSheet, type Point, type Sheet } from "./sheet";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;
let sheet: Sheet;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  sheet = await openSheet(workshop);
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  for (let n = 0; n < 3; n += 1) await sheet.page.keyboard.press("Escape");
});

const given = (clauses: string) => sheet.scaled(clauses, 1, [50, 0]);
const square = "rect 0,0 100,100";
const key = (name: string) => sheet.page.keyboard.press(name);
const selects = (numbers: number[]) => expect.poll(sheet.selected).toEqual(numbers);
const says = (words: string | RegExp) =>
  sheet.prompt().filter({ hasText: words }).waitFor({ timeout: 10_000 });
const tells = (words: string) => sheet.page.getByText(words).first().waitFor({ timeout: 10_000 });
const chooser = () => sheet.page.getByRole("menu").getByRole("menuitem");
const offers = (names: string[]) =>
  expect
    .poll(() => chooser().evaluateAll((all) => all.map((one) => one.getAttribute("aria-label"))))
    .toEqual(names);
/** The first place of a shape of the drawing. */
const start = async (n: number) => (await sheet.shapes())[n]?.points.slice(0, 2);

const look = (): Promise<Painted> => painted(sheet.page, sheet.page.locator("html"));
const inkAt = (seen: Painted, at: Point) => seen.at(...sheet.pixel(at)).join();

it("pro_select_rmb_repeat: the right button begins the last tool again; at first it does nothing", async () => {
  await given(square);
  await sheet.click([50, 50], "right");
  await says("Select");
  await sheet.tool("Move");
  await sheet.click([50, 0]);
  await sheet.click([50, 50], "right");
  await sheet.click([0, 0]);
  await sheet.click([20, 0]);
  await expect.poll(() => start(0)).toEqual([20, 0]);
  await says("Select");
  await sheet.click([50, 50], "right");
  await says("Move");
});

it("pro_select_radius, pro_options_radius: a click selects within 8 pixels, or as many as are set", async () => {
  const edges = (near: number, far: number) =>
    given(`rect 0,${near} 100,${near + 60}; rect 150,${far} 250,${far + 60}`);
  const picks = async () => {
    await sheet.click([200, -10]);
    await selects([]);
    await sheet.click([50, -10]);
    await selects([1]);
    await sheet.click([200, -10]);
    await selects([]);
  };
  // 7.9 pixels from the one, 8.1 from the other.
  await edges(-2.1, -1.9);
  await picks();
  const radius = async (text: string) => {
    await sheet.page.getByRole("link", { name: "Settings" }).click();
    await sheet.page.getByLabel("Search settings").fill("pick_radius");
    const field = sheet.page.getByRole("textbox", { name: "Options, pick radius" });
    await field.fill(text);
    await field.press("Enter");
    await sheet.page.getByLabel("Search settings").fill("");
    await sheet.page.getByRole("link", { name: "Draw", exact: true }).click();
  };
  await radius("4");
  await edges(-6.1, -5.9);
  await picks();
  await radius("8");
});

it("pro_snap_vertex: the nearest vertex within the radius; without one the step stays open", async () => {
  await given(square);
  await sheet.tool("Point");
  await sheet.snap([50, 40]);
  await tells("There is no vertex within the selection radius.");
  await says("Point");
  expect(await sheet.added()).toEqual([]);
  // The radius of 8 pixels is drawn about the mouse, red.
  await sheet.move([50, 40]);
  const armed = await look();
  const reds = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10].filter((n) => {
    const [r, g, b] = armed.at(...sheet.pixel([50 + n, 40]));
    return r > g + 40 && r > b + 40;
  });
  expect(reds.length).toBeGreaterThan(0);
  expect(reds.filter((n) => n < 7 || n > 8)).toEqual([]);
  await sheet.snap([103, 100]);
  expect((await sheet.drawn()).points).toEqual([100, 100, 0]);
});

it("pro_snap_centre: the centre of the nearest arc; a line has none", async () => {
  await given("line 0,0,0.5 10,0; line 100,0 200,0");
  await sheet.tool("Point");
  await sheet.snap([150, 3], "c");
  await tells("There is no centre within the selection radius.");
  await sheet.snap([5, -3], "c");
  expect((await sheet.drawn()).points).toEqual([5, 3.75, 0]);
});

it("pro_snap_midpoint: of the segment whose middle three fifths are near", async () => {
  await given("line 0,0 100,0");
  await sheet.tool("Point");
  await sheet.snap([5, 3], "m");
  await tells("There is no midpoint within the selection radius.");
  await sheet.snap([25, 3], "m");
  expect((await sheet.drawn()).points).toEqual([50, 0, 0]);
  await key("Escape");
  await given("line 0,0,1 10,0");
  await sheet.tool("Point");
  await sheet.snap([5, -6], "m");
  expect((await sheet.drawn()).points).toEqual([5, -5, 0]);
});

it("pro_snap_intersection: of lines, of a line and an arc, of two arcs", async () => {
  for (const [clauses, mouse, met] of [
    ["line 0,0 100,100; line 0,100 100,0", [53, 52], [50, 50]],
    ["circle 200,0 25; line 150,0 250,0", [226, 3], [225, 0]],
    ["circle 0,-100 30; circle 36,-100 30", [20, -74], [18, -76]],
  ] as const) {
    await given(clauses);
    await sheet.tool("Point");
    await sheet.snap(mouse, "i");
    expect((await sheet.drawn()).points).toEqual([...met, 0]);
    await key("Escape");
  }
});

it("pro_snap_nearest: the nearest place on any shape, within the radius", async () => {
  await given("line 0,0 100,0");
  await sheet.tool("Point");
  await sheet.snap([40, 9], "n");
  await tells("There is no nearest within the selection radius.");
  await sheet.snap([40, 3], "n");
  expect((await sheet.drawn()).points).toEqual([40, 0, 0]);
});

it("pro_snap_none: Q takes the snap back", async () => {
  await given(square);
  await sheet.tool("Point");
  await sheet.move([98, 97]);
  await key("v");
  await key("q");
  await sheet.click([98, 97]);
  expect((await sheet.drawn()).points).toEqual([98, 97, 0]);
});

it("pro_snap_oneshot: a snap is for one pick, and the line below tells which is in force", async () => {
  await given(square);
  const inForce = () => sheet.page.locator(".sheet-status-keys span").allTextContents();
  await sheet.tool("Move");
  await sheet.click([50, 0]);
  await sheet.click([50, 50], "right");
  await sheet.move([98, 2]);
  await key("v");
  await expect.poll(inForce).toEqual(["vertex"]);
  await sheet.click([98, 2]);
  await expect.poll(inForce).toEqual([]);
  // A few pixels from the corner: it goes there, not to the corner.
  await sheet.click([96, 97]);
  await expect.poll(() => start(0)).toEqual([-4, 97]);
});

it("pro_snap_ortho: G keeps a pick on the row or the column of the base point", async () => {
  await given(square);
  await sheet.tool("Line");
  await sheet.click([10, 20]);
  for (const at of [
    [60, 35],
    [75, 90],
    [45, 60],
  ] as const)
    await sheet.snap(at, "g");
  await sheet.click([50, 50], "right");
  // From (10,20): 50 > 15, across; then from (60,20): 15 < 70, up; then (60,90): 15 < 30, down.
  expect((await sheet.drawn()).points).toEqual([10, 20, 0, 60, 20, 0, 60, 90, 0, 60, 60, 0]);
  await given(square);
  await sheet.tool("Line");
  await sheet.click([10, 20]);
  await sheet.snap([40, 50], "g");
  await sheet.click([50, 50], "right");
  expect((await sheet.drawn()).points).toEqual([10, 20, 0, 10, 50, 0]);
});

it("pro_snap_zoom_in: Z shows half as much, about the mouse, in the middle of a tool", async () => {
  await given(square);
  await sheet.tool("Line");
  await sheet.click([0, 0]);
  await sheet.move([30, 40]);
  await key("z");
  const middle = await sheet.middle();
  const near = (told: Point, at: Point) => {
    expect(told[0]).toBeCloseTo(at[0], 1);
    expect(told[1]).toBeCloseTo(at[1], 1);
  };
  near(await sheet.placeAt(middle), [30, 40]);
  near(await sheet.placeAt([middle[0] + 100, middle[1] - 60]), [80, 70]);
  await sheet.page.mouse.click(middle[0], middle[1]);
  await sheet.page.mouse.click(middle[0], middle[1], { button: "right" });
  const { points } = await sheet.drawn();
  expect(points.slice(0, 3)).toEqual([0, 0, 0]);
  expect(points[3]).toBeCloseTo(30, 2);
  expect(points[4]).toBeCloseTo(40, 2);
});

it("pro_select_window, pro_select_crossing: a region takes what is inside, or what it touches", async () => {
  await given("rect 0,0 10,10; rect 40,0 60,20; rect -60,-60 150,130");
  await sheet.drag([-1, -1], [50, 30]);
  await selects([1]);
  await sheet.drag([50, 30], [-1, -1]);
  await selects([1, 2]);
});

it("pro_select_region: a rectangle follows the mouse, and is the region when the button is let go", async () => {
  await given("rect 2,2 49,39; rect 2,60 51,90; rect 2,-30 51,-10");
  const before = await look();
  await sheet.move([0, 0]);
  await sheet.page.mouse.down();
  for (const to of [
    [30, 70],
    [50, 40],
  ] as const) {
    await sheet.page.mouse.move(...sheet.pixel(to), { steps: 4 });
    const now = await look();
    const changed = (at: Point) => inkAt(now, at) !== inkAt(before, at);
    const inside: Point = [to[0] - 4, to[1] - 6];
    expect([changed(inside), changed([to[0] + 6, 20]), changed([20, to[1] + 5])]).toEqual([
      true,
      false,
      false,
    ]);
  }
  await sheet.page.mouse.up();
  await selects([1]);
});

it("pro_select_rmb_finish: the right button ends the picking of shapes", async () => {
  await given("rect 0,0 40,40; rect 80,0 120,40");
  await sheet.tool("Move");
  await sheet.click([20, 0]);
  await sheet.click([100, 0]);
  await says("(2 picked)");
  await sheet.click([60, 60], "right");
  await says(/base/i);
  await sheet.click([0, 0]);
  await sheet.click([0, 50]);
  await expect
    .poll(async () => [await start(0), await start(1)])
    .toEqual([
      [0, 50],
      [80, 50],
    ]);
});

it("pro_select_rmb_cancel: the right button gives up what a left click would complete", async () => {
  await given(square);
  await sheet.tool("Move");
  await sheet.click([50, 0]);
  await sheet.click([50, 50], "right");
  await sheet.click([0, 0]);
  await sheet.move([40, 40]);
  const { points } = (await sheet.shapes())[0] ?? {};
  await sheet.click([40, 40], "right");
  await says("Select");
  expect((await sheet.shapes())[0]?.points).toEqual(points);
});

/** A square, and a copy of it in red that was made with the button of the group. */
async function stacked(): Promise<void> {
  await given(square);
  await sheet.click([50, 0]);
  await selects([1]);
  await sheet.tool("copy: the selection into red");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(4);
  await sheet.tool("Select none");
  await selects([]);
}

it("pro_select_chooser: several shapes under a click are offered in the colours of their groups", async () => {
  await stacked();
  await sheet.click([50, 0]);
  await offers(["Shape 1, layer black", "Shape 4, layer red"]);
  const colours = await chooser().evaluateAll((all) =>
    all.map((one) => getComputedStyle(one).backgroundColor),
  );
  const swatch = (group: string) =>
    sheet.page
      .locator(".group-name", { hasText: group })
      .locator(".swatch")
      .evaluate((one) => getComputedStyle(one).backgroundColor);
  expect(colours).toEqual([await swatch("black"), await swatch("red")]);
  expect(await sheet.selected()).toEqual([]);
  await chooser().last().click();
  await selects([4]);
  expect(await chooser().count()).toBe(0);
});

it("pro_select_chooser_mark: what is selected or picked already is marked", async () => {
  await stacked();
  await sheet.click([50, 0]);
  await chooser().first().click();
  await selects([1]);
  await sheet.click([50, 0]);
  await offers(["Shape 1, layer black, selected", "Shape 4, layer red"]);
  await chooser().first().click();
  await selects([1]);
  // A tool that picks takes out what is chosen again.
  await sheet.tool("Select none");
  await selects([]);
  await sheet.tool("Move");
  await sheet.click([50, 0]);
  await chooser().first().click();
  await says("(1 picked)");
  await sheet.click([50, 0]);
  await offers(["Shape 1, layer black, selected", "Shape 4, layer red"]);
  await chooser().first().click();
  await says("(0 picked)");
});

it("pro_select_chooser_order: they are offered in cutting order", async () => {
  await stacked();
  await sheet.tool("Reverse the order");
  await expect.poll(async () => (await sheet.shapes())[0]?.group).toBe("red");
  const offered = ["Shape 1, layer red", "Shape 4, layer black"];
  await expect
    .poll(async () => {
      await key("Escape");
      await sheet.click([50, 0]);
      return chooser().evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));
    })
    .toEqual(offered);
});

it("a hand that is quicker than the link: what follows an operation means what came of it", async () => {
  const far = await openWorkshop({ lagMs: 300 });
  try {
    const slow = await openSheet(far);
    await slow.scaled(square, 1, [50, 0]);
    const given = (await slow.shapes()).length;
    await slow.click([50, 0]);
    await slow.click([150, 50]);
    await slow.drag([150, 120], [120, 80]);
    await slow.click([50, 0]);
    await slow.page.keyboard.press("Delete");
    await expect.poll(async () => (await slow.shapes()).length).toBe(given - 1);
    expect(await slow.selected()).toEqual([]);
    expect(far.mistakes).toEqual([]);
  } finally {
    await far.close();
  }
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
