/** Digitizing at a page: points recorded with the simulated machine, seen on the sheet, and made a shape. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { ofUnit, shown } from "../../src/units/quantity";
import { painted } from "./pixels";
import { arm, openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 50 });
  await script(workshop, "draw", { op: { op: "new" } });
  await script(workshop, "draw", { op: { op: "do", clauses: "rect 0,0 100,100" } });
  page = await workshop.page({ width: 1360, height: 900 });
  await page.getByRole("link", { name: "Draw" }).click();
  await arm(page);
});
afterAll(() => workshop?.close());

const panel = () => page.getByRole("region", { name: "Digitize" });
const press = (name: string) => panel().getByRole("button", { name, exact: true }).click();
const lines = async () => (await stateOf(workshop)).handConsole.lines;
const idle = async () => (await stateOf(workshop)).machine.state === "idle";

/** Drives to a place, in the unit of the page, and records it. */
async function record(x: number, y: number): Promise<void> {
  const before = (await stateOf(workshop)).motion.at.machine;
  await panel().getByLabel("Move to X").fill(String(x));
  await panel().getByLabel("Move to Y").fill(String(y));
  if (Math.hypot(before[0], before[1]) > 0 || x + y > 0) await press("Move to");
  await until(async () => {
    const { motion, units } = await stateOf(workshop);
    const [at, to] = motion.at.machine;
    return (
      Math.hypot(at - ofUnit(shown(x), units), to - ofUnit(shown(y), units)) < 1e-3 &&
      (await idle())
    );
  }, `the tool is at ${x},${y}`);
  const count = (await stateOf(workshop)).digitized?.points.length ?? 0;
  await press("Record");
  await until(
    async () => (await stateOf(workshop)).digitized?.points.length === count + 1,
    "the point is recorded",
  );
}

/** Counts the pixels of the sheet that have a colour of the theme, or nearly. */
async function inked(token: string): Promise<number> {
  const hex = await page.evaluate(
    (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim(),
    token,
  );
  const ink = [1, 3, 5].map((n) => Number.parseInt(hex.slice(n, n + 2), 16));
  const sheet = await painted(page, page.locator(".sheet-box"));
  return sheet.count((pixel) => ink.every((part, n) => Math.abs(part - (pixel[n] ?? 0)) < 24));
}

it("pro_digitize_d30: the sheet shows all points and segments, the current one marked", async () => {
  await press("Digitize");
  await until(async () => (await lines())[1] === "Cur=0 of 0", "digitizing");
  expect(await inked("--draw-digitized")).toBe(0);
  await record(0, 0);
  await press("Line / arc");
  await record(4, 3);
  await press("Line / arc");
  await record(8, 0);
  await expect.poll(() => panel().locator("tbody tr").count()).toBe(3);
  expect(await panel().locator("tr[aria-current]").textContent()).toContain("3 line");
  await press("Show points");
  await expect.poll(() => inked("--draw-digitized")).toBeGreaterThan(400);
  expect(await inked("--draw-digitized-current")).toBeGreaterThan(60);
  await press("Back");
  await until(async () => (await lines())[1] === "Cur=2 of 3", "the arc point");
  await expect.poll(() => panel().locator("tr[aria-current]").textContent()).toContain("2 arc");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/digitize.png` });
  expect(await violations(page)).toEqual([]);
});

it("a shape is saved, is last in the drawing, and is taken back by undo", async () => {
  await press("Save closed");
  await until(async () => (await stateOf(workshop)).drawing?.shapes === 2, "the shape");
  await expect.poll(lines).toEqual(["Shape saved", "2 in the drawing"]);
  await page.getByRole("button", { name: "Undo" }).click();
  await until(async () => (await stateOf(workshop)).drawing?.shapes === 1, "undone");
});

it("what the functions 31 to 33 want in sight is seen", async () => {
  await press("Show points");
  const near = await inked("--draw-digitized");
  await press("Zoom out");
  await press("Zoom out");
  await expect.poll(() => inked("--draw-digitized")).toBeLessThan(0.6 * near);
  await press("Show all");
  await expect.poll(() => inked("--draw-digitized")).toBeGreaterThan(0.6 * near);
});

it("points are not lost without a question", async () => {
  await press("Insert after");
  await until(async () => (await lines())[1]?.startsWith("Cur=") ?? false, "inserted");
  await press("Exit");
  await panel().getByText("Lose 4 points?").waitFor();
  await press("No");
  await expect.poll(lines).toContain("Cur=3 of 4");
  await press("Exit");
  await press("Yes");
  await panel().getByRole("button", { name: "Digitize" }).waitFor();
  expect((await stateOf(workshop)).digitized).toBe(null);
  expect(workshop.mistakes).toEqual([]);
});
