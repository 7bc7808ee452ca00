/** The screen tells cut lines from uncut ones while a job runs. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { type Painted, type Pixel, painted } from "./pixels";
import { arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

/** One line, millimetres. */
const length = 600;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 2 });
  const draw = (op: object) => script(workshop, "draw", { op });
  await draw({ op: "new" });
  await draw({ op: "do", clauses: `line 0,0 ${length},0; set black speed=600` });
  await draw({ op: "save", name: "line.rsg" });
  page = await workshop.page({ width: 1360, height: 800 });
});
afterAll(() => workshop?.close());

/** Distance of the tool along the line while it cuts, millimetres. */
async function cutSoFar(): Promise<number> {
  const { motion } = await stateOf(workshop);
  return motion.cutting ? motion.at.machine[0] : 0;
}

/** A colour of the picture, by its name among the tokens. */
async function colour(token: string): Promise<(pixel: Pixel) => boolean> {
  const hex = await page.evaluate(
    (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim(),
    token,
  );
  const wanted = [1, 3, 5].map((n) => Number.parseInt(hex.slice(n, n + 2), 16));
  return (pixel) => pixel.every((value, n) => Math.abs(value - (wanted[n] ?? 0)) < 24);
}

/** From where to where across the picture a colour is painted on the line that has most of it. */
function across(picture: Painted, is: (pixel: Pixel) => boolean): [from: number, to: number] {
  const rows = Array.from({ length: picture.height }, (_, y) =>
    Array.from({ length: picture.width }, (_, x) => x).filter((x) => is(picture.at(x, y))),
  );
  const [most = []] = rows.sort((a, b) => b.length - a.length);
  return [most[0] ?? Number.NaN, most.at(-1) ?? Number.NaN];
}

it("pro_display_progress: the part of a line that is cut has a colour of its own, up to the tool", async () => {
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Machine", exact: true }).click();
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await arm(page);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByRole("radio", { name: "Top" }).click();
  await until(async () => (await cutSoFar()) > 0.25 * length, "a quarter is cut");
  const [made, ahead] = [await colour("--view-done"), await colour("--view-cut")];
  // The tool goes on while the picture is taken, and its mark covers some of the line.
  const least = (await cutSoFar()) / length;
  const picture = await painted(page, page.locator(".path-lines"));
  const most = (await cutSoFar()) / length;
  const [[from, to], [, end]] = [across(picture, made), across(picture, ahead)];
  const share = (to - from) / (end - from);
  expect(end - from).toBeGreaterThan(300);
  expect(share).toBeGreaterThan(least - 0.06);
  expect(share).toBeLessThan(most + 0.06);
  expect(most).toBeLessThan(0.9);
  expect(workshop.mistakes).toEqual([]);
});
