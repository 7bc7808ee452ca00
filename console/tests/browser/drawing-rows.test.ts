/** Rows of the ledger about drawing something new, with the mouse on the sheet. A pixel is half a millimetre. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { painted } from "./pixels";
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
  await sheet.page.keyboard.press("Escape");
  await sheet.scaled("", 0.5, [30, 20]);
});

/** A tool is at work until it is done or given up. */
const working = () => sheet.page.locator(".tool-button[aria-pressed=true]").count();

async function clicks(tool: string, ...places: readonly Point[]): Promise<void> {
  await sheet.tool(tool);
  for (const at of places) await sheet.click(at);
}

it("pro_draw_line: places are clicked, the right button ends it", async () => {
  await clicks("Line", [0, 0], [10, 0], [10, 10]);
  await sheet.click([40, 40], "right");
  expect(await sheet.drawn()).toMatchObject({
    closed: false,
    points: [0, 0, 0, 10, 0, 0, 10, 10, 0],
  });
});

it("pro_draw_line_type: a place is clicked, the others are typed", async () => {
  await clicks("Line", [0, 0]);
  await sheet.type("10mm,0");
  await sheet.type("10mm,10mm");
  await sheet.page.keyboard.press("Enter");
  expect(await sheet.drawn()).toMatchObject({
    closed: false,
    points: [0, 0, 0, 10, 0, 0, 10, 10, 0],
  });
});

it("pro_draw_poly_open_rmb: the right button leaves it open, and discards a single place", async () => {
  await clicks("Line", [0, 0]);
  await sheet.click([40, 40], "right");
  await expect.poll(working).toBe(0);
  expect(await sheet.added()).toEqual([]);
  await clicks("Line", [0, 0], [10, 0]);
  await sheet.click([40, 40], "right");
  expect(await sheet.drawn()).toMatchObject({ closed: false, points: [0, 0, 0, 10, 0, 0] });
});

it("pro_draw_rect: two opposite corners; it starts at the first", async () => {
  await clicks("Rectangle", [10, 10], [60, 40]);
  expect(await sheet.drawn()).toMatchObject({
    closed: true,
    points: [10, 10, 0, 60, 10, 0, 60, 40, 0, 10, 40, 0],
  });
  await sheet.click([30, 10]);
  await expect.poll(() => sheet.fact("Vertices").textContent()).toBe("4");
  expect(await sheet.fact("Size").textContent()).toBe("1.969 × 1.181 in");
});

it("pro_draw_circle: its centre, then a place on it", async () => {
  await clicks("Circle", [50, 50], [75, 50]);
  const { closed, points } = await sheet.drawn();
  expect({ closed, points }).toEqual({ closed: true, points: [75, 50, 1, 25, 50, 1] });
  // Two half circles anticlockwise: the area is that of r = 25.
  await sheet.click([50, 25]);
  await expect.poll(() => sheet.fact("Kind").textContent()).toBe("closed, counter-clockwise");
  expect(await sheet.fact("Size").textContent()).toBe("1.969 × 1.969 in");
});

it("pro_draw_arc: the bulge of a segment follows the mouse", async () => {
  for (const [mouse, bulge] of [
    [[5, -5], 1],
    [[5, 2.5], -0.5],
    [[5, 0], 0],
  ] as const) {
    await sheet.scaled("", 0.5, [30, 20]);
    await clicks("Arc", [0, 0], [10, 0], mouse);
    await sheet.click([40, 40], "right");
    expect((await sheet.drawn()).points).toEqual([0, 0, bulge, 10, 0, 0]);
  }
});

it("pro_draw_arc_open: the right button, or the last vertex again, leaves it open", async () => {
  const bent = { closed: false, points: [0, 0, 1, 10, 0, 0] };
  await clicks("Arc", [0, 0], [10, 0], [5, -5]);
  await sheet.click([40, 40], "right");
  expect(await sheet.drawn()).toMatchObject(bent);
  await sheet.scaled("line 10,0 10,60", 0.5, [30, 20]);
  await clicks("Arc", [0, 0]);
  await sheet.snap([10.5, 0.5]);
  await sheet.click([5, -5]);
  await sheet.snap([10.5, 0.5]);
  expect(await sheet.drawn()).toMatchObject(bent);
  await sheet.scaled("", 0.5, [30, 20]);
  await clicks("Arc", [0, 0]);
  await sheet.click([40, 40], "right");
  await expect.poll(working).toBe(0);
  expect(await sheet.added()).toEqual([]);
});

it("pro_select_lmb_point: a left click gives a place, exactly with a snap", async () => {
  await clicks("Point", [12, 34]);
  expect((await sheet.drawn()).points).toEqual([12, 34, 0]);
  await sheet.scaled("rect 0,0 100,60", 0.5, [30, 20]);
  await sheet.tool("Point");
  await sheet.snap([98, 58.5]);
  expect((await sheet.drawn()).points).toEqual([100, 60, 0]);
});

it("pro_edit_bulge_drag: a segment is bent to where the mouse is", async () => {
  await sheet.scaled("line 0,0 100,0", 0.5, [30, 20]);
  await clicks("Bulge", [50, 0], [50, -25]);
  await expect.poll(async () => (await sheet.shapes())[0]?.points).toEqual([0, 0, 0.5, 100, 0, 0]);
  // Its centre is found by C with the mouse on the arc, its radius is what lies between.
  await sheet.page.keyboard.press("Escape");
  await sheet.tool("Point");
  await sheet.snap([50, -25], "c");
  expect((await sheet.drawn()).points).toEqual([50, 37.5, 0]);
});

it("pro_draw_point: a click makes a mark, which is drilled", async () => {
  const at = sheet.pixel([5, 5]);
  const mark = async () => {
    await sheet.page.mouse.move(at[0] + 120, at[1] - 60);
    const seen = await painted(sheet.page, sheet.page.locator("html"));
    return JSON.stringify([-2, -1, 0, 1, 2].map((n) => seen.at(at[0] + n, at[1] + n)));
  };
  const empty = await mark();
  await clicks("Point", [5, 5]);
  expect(await sheet.drawn()).toMatchObject({ closed: false, points: [5, 5, 0] });
  await sheet.page.keyboard.press("Escape");
  await expect.poll(mark).not.toBe(empty);
  await sheet.page.getByRole("button", { name: "Make the part program…" }).click();
  await sheet.page.getByRole("button", { name: "Write" }).click();
  await sheet.page.locator(".job-name", { hasText: "drawing.sbp" }).waitFor();
  const program = readFileSync(join(workshop.parts, "drawing.sbp"), "utf8");
  // In inches.
  expect(program).toMatch(/^J2,0\.19685039,0\.19685039\nMZ,-0\.39370079$/m);
  await sheet.page.getByRole("link", { name: "Draw" }).click();
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
