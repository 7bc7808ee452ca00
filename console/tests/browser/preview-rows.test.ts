/** Rows of the manual about the preview: lines, extents, material, clearing. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { type Painted, type Pixel, painted } from "./pixels";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  moment,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  const moves = Array.from(
    { length: 500 },
    (_, n) => `M2,${(n % 25) / 5},${Math.floor(n / 25) / 5}`,
  );
  const line = (text: string, n: number) => `'line ${n}\n${text}\n`;
  file("thousand.sbp", `SA\nJ2,8,6\nMZ,-.1\n${moves.map(line).join("")}JZ,.5\nEND\n`);
  file("ring.sbp", "SA\nMZ,-.1\nCC,4\nJZ,.5\nJ2,-3,-3\nEND\n");
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

const picture = () => page.locator(".path-lines");
const box = () => page.locator(".path-box");
const pictures = async () => Number(await picture().getAttribute("data-pictures"));
const idle = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "the machine stands");

/** Opens a file and waits until all of it is drawn. */
async function opens(name: string): Promise<void> {
  await script(workshop, "open", { name });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, `${name} is previewed`);
  await page.locator('[data-path="all"]').waitFor();
  await drawn(0);
}

/** Waits until more pictures were drawn than before, and no other comes. */
async function drawn(before: number): Promise<void> {
  await expect.poll(pictures).toBeGreaterThan(before);
  let last = -1;
  await until(async () => {
    const [then, now] = [last, await pictures()];
    last = now;
    if (then === now) return true;
    await moment(400);
    return false;
  }, "the picture stands");
}

const isRed = ([r, g, b]: Pixel): boolean => r > 150 && g < 110 && b < 110;
const isBlue = ([r, g, b]: Pixel): boolean => b > 100 && r < 100 && b > g;

async function different(before: Painted): Promise<number> {
  const after = await painted(page, box());
  let sum = 0;
  for (let y = 0; y < after.height; y += 3)
    for (let x = 0; x < after.width; x += 3) {
      const [a, b] = [before.at(x, y), after.at(x, y)];
      sum += Number(a.some((value, n) => Math.abs(value - (b[n] ?? 0)) > 40));
    }
  return sum;
}

it("sbp_con_preview: a thousand lines are drawn, jogs red; pan, zoom, turn; extents, time; clear", async () => {
  await opens("thousand.sbp");
  await until(async () => {
    const now = await painted(page, box());
    return now.count(isRed) > 50 && now.count(isBlue) > 300;
  }, "jogs are red, moves are not");
  const facts = page.getByLabel("Extents and time");
  expect(await facts.textContent()).toMatch(/X0\.000 … 8\.000Y0\.000 … 6\.000.*Time\d+:\d\d/);

  const at = await box().boundingBox();
  if (!at) throw new Error("there is no picture");
  const [x, y] = [at.x + at.width / 2, at.y + at.height / 2];
  const drag = async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 80, y + 40, { steps: 5 });
    await page.mouse.up();
  };
  const changes = async (what: string, hand: () => Promise<void>) => {
    const [before, count] = [await painted(page, box()), await pictures()];
    await hand();
    await until(async () => (await different(before)) > 30, what);
    await drawn(count);
  };
  await changes("panned", drag);
  await changes("zoomed", async () => {
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -300);
  });
  await changes("fitted", () => page.getByRole("button", { name: "Fit" }).click());
  await changes("seen in 3D", async () => {
    await page.getByRole("radio", { name: "3D" }).click();
  });
  await changes("turned", drag);
  await page.getByRole("radio", { name: "Top" }).click();

  await carryOut(workshop, page, "SP");
  await page.getByRole("button", { name: "PREVIEW" }).waitFor();
  await page.locator('[data-path="all"]').waitFor();
  await page.getByRole("button", { name: "Clear", exact: true }).click();
  await page.getByText("The preview is cleared.").waitFor();
  expect(await picture().getAttribute("data-path")).toBe("none");
});

it("sbp_cmd_sp_clear: SP in preview empties the picture on every page, the next run draws again", async () => {
  await idle();
  await opens("thousand.sbp");
  const other = await workshop.page();
  await other.locator('[data-path="all"]').waitFor();
  await command(page, "SP");
  await other.locator('[data-path="none"]').waitFor();
  await page.locator('[data-path="none"]').waitFor();
  await other.close();
  await idle();
  await page.getByRole("button", { name: "Start" }).click();
  await page.locator('[data-path="all"]').waitFor();
  await idle();
  await carryOut(workshop, page, "SM");
  await page.getByRole("button", { name: "SIMULATED" }).waitFor();
});

it("sbp_con_preview_cut: with simulate on, CC,4 takes a ring a quarter of an inch wide out of the stock", async () => {
  await carryOut(workshop, page, "VP,,,,,1");
  await opens("ring.sbp");
  const stock = page.getByRole("button", { name: "Stock" });
  await expect.poll(() => stock.getAttribute("aria-pressed")).toBe("true");
  const bared = async () =>
    ((await picture().getAttribute("data-bared")) ?? "").split(" ").map((mm) => Number(mm) / 25.4);
  expect(await bared(), "nothing is cut yet").toEqual([0]);
  await page.getByRole("slider", { name: "Planned time" }).focus();
  await page.keyboard.press("End");
  await until(async () => (await bared()).length === 3, "all is cut");
  const [area = 0, wide = 0, deep = 0] = await bared();
  // A ring about a circle of 4 inches: its outside is wider by the cutter, and so is its inside narrower.
  for (const inches of [wide, deep]) expect(inches).toBeCloseTo(4.25, 1);
  expect(area / 25.4 / (Math.PI * 4), "width of the ring").toBeCloseTo(0.25, 2);
});
