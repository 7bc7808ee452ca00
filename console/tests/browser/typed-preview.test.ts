/**
 * Typed commands are on the screen: moves are drawn as they are made, a file that is run is the one that is
 * shown.
 */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { type Pixel, painted } from "./pixels";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 3 });
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  file("a.sbp", "SA\nJ2,1,1\nMZ,-.1\nMX,3\nJZ,.5\nEND\n");
  file("b.sbp", "'the second file\nSA\nJ2,8,6\nMZ,-.2\nMX,12\nMY,8\nJZ,.5\nEND\n");
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

const marks = () => page.locator(".path-marks");
const typed = async () => Number(await marks().getAttribute("data-typed"));
const picture = () => page.locator(".path-lines");
const name = () => page.locator(".job-name strong");
const isBlue = ([r, g, b]: Pixel): boolean => b > 100 && r < 100 && b > g;
const inked = async () => (await painted(page, page.locator(".path-box"))).count(isBlue);

/** The open file, when its picture is there. */
const shown = async () => {
  const { opened } = await stateOf(workshop);
  return opened?.preview.state === "ready" ? opened.name : "";
};

it("sbp_cmd_sp: after SP typed moves are drawn, one behind the other", async () => {
  await page.getByText("Choose a file to see its tool path.").waitFor();
  await carryOut(workshop, page, "SP");
  await carryOut(workshop, page, "MX,5");
  await expect.poll(typed).toBe(1);
  expect(await page.getByText("Choose a file to see its tool path.").count()).toBe(0);
  const line = await inked();
  await carryOut(workshop, page, "CC,4");
  await until(async () => (await typed()) > 20, "the circle is drawn");
  expect(await inked()).toBeGreaterThan(line);
  await page.getByRole("img", { name: "What was typed" }).waitFor();
});

it("sbp_cmd_sp_clear: SP in preview empties what was typed, SM leaves nothing of it", async () => {
  await carryOut(workshop, page, "SP");
  await expect.poll(typed).toBe(0);
  await page.getByText("Choose a file to see its tool path.").waitFor();
  await carryOut(workshop, page, "MY,2");
  await expect.poll(typed).toBe(2);
  await carryOut(workshop, page, "SM");
  await expect.poll(typed).toBe(0);
});

it("sbp_con_preview__typed: in Move mode a typed move is drawn while it is made", async () => {
  await carryOut(workshop, page, "MS,.3");
  await command(page, "MX,5");
  const drawnMeanwhile = async () => {
    const ink = await inked();
    const { job } = await stateOf(workshop);
    if (job?.ended) throw new Error("the move ended, and nothing was drawn before");
    return ink > 20;
  };
  await until(drawnMeanwhile, "the line grows");
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "MX is done");
  await expect.poll(typed).toBe(1);
  await carryOut(workshop, page, "MS,4");
});

/** Types FP, and looks whether its file is the one on the screen. */
async function runsOnTheScreen(line: string, file: string): Promise<void> {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  await command(page, line);
  await until(async () => ((await stateOf(workshop)).job?.run ?? 0) > before, "it is begun");
  await until(async () => (await shown()) === file, `${file} is on the screen`);
  await picture().and(page.locator('[data-path="all"]')).waitFor();
  await expect.poll(() => name().textContent()).toBe(file);
  await page.locator(".listing").getByText("the second file").waitFor();
  await until(async () => {
    const { job, machine } = await stateOf(workshop);
    return job?.ended === "ok" && machine.state === "idle";
  }, "it is run");
  await page.locator(".job-status", { hasText: "finished at" }).waitFor();
  await expect.poll(() => page.locator(".job-times b").first().textContent()).toBe("100");
}

it("sbp_cmd_sp: a typed FP shows its file in preview, with SPACE in large", async () => {
  await script(workshop, "open", { name: "a.sbp" });
  await until(async () => (await shown()) === "a.sbp", "the first file is open");
  await carryOut(workshop, page, "SP");
  await runsOnTheScreen("FP,b.sbp", "b.sbp");
  await carryOut(workshop, page, "SM");
});

it("sbp_file_fp: a typed FP shows its file in Move mode, with its parameters and how far it is", async () => {
  await script(workshop, "open", { name: "a.sbp" });
  await until(async () => (await shown()) === "a.sbp", "the first file is open");
  await command(page, "FP,b.sbp,.5,.5,1,2");
  await until(async () => (await shown()) === "b.sbp", "the second file is on the screen");
  const half = async () => {
    const { job, motion, opened } = await stateOf(workshop);
    const same = job?.hash !== null && job?.hash === opened?.hash;
    return same && job?.ended === null && motion.progress > 0.2 && motion.progress < 0.9;
  };
  await until(half, "it is told how far it is");
  expect(await typed(), "its moves are its own picture").toBe(0);
  const { opened } = await stateOf(workshop);
  expect(opened?.parameters).toMatchObject({ proportion: [0.5, 0.5, 1], repetitions: 2 });
  const facts = page.getByLabel("Extents and time");
  expect(await facts.textContent()).toContain("X4.000 … 6.000");
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "it is run");
  await page.locator(".job-status", { hasText: "finished at" }).waitFor();
  // It is open as it ran: run by FP once more it is the same.
  await runsOnTheScreen("FP,b.sbp,.5,.5,1,2", "b.sbp");
  await runsOnTheScreen("FP,b.sbp", "b.sbp");
  expect((await stateOf(workshop)).opened?.parameters).toMatchObject({ repetitions: 1 });
});

it("sbp_val_vp_rotary: with five axes the path can be seen on the cylinder that B turns", async () => {
  const toggle = page.getByRole("button", { name: "Rotary" });
  expect(await toggle.count(), "three axes turn nothing").toBe(0);
  await carryOut(workshop, page, "VD,,5");
  const rolled = "J2,0,0\nMZ,-.1\nM5,1,0,-.1,0,90\nJZ,1\nEND\n";
  writeFileSync(join(workshop.parts, "rolled.sbp"), `SA\n${rolled}`);
  await script(workshop, "open", { name: "rolled.sbp" });
  await until(async () => (await shown()) === "rolled.sbp", "it is open");
  const facts = page.getByLabel("Extents and time");
  await expect.poll(() => facts.textContent()).toMatch(/Y0\.000 … 0\.000Z-0\.100/);
  await toggle.click();
  // Half of the blank of 6 inches, less a tenth: a quarter turn brings that to the side.
  await expect.poll(() => facts.textContent()).toMatch(/Y-2\.900 … 0\.000Z-3\.000 … /);
  await picture().and(page.locator('[data-path="all"]')).waitFor();
  await toggle.click();
  await expect.poll(() => facts.textContent()).toMatch(/Y0\.000 … 0\.000Z-0\.100/);
  await carryOut(workshop, page, "VD,,3");
});
