/** A controller that waits for a tool by itself (`Tool` of grblHAL): the page says so, jogs, and has it go on. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import {
  act,
  arm,
  hold,
  keysOf,
  script,
  stands,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController({ "line.sbp": "MX,1\nMX,2\n" });
  ({ controller, workshop, page } = shop);
  await arm(page);
  return shop.close;
});

const waits = async () => (await controller.look()).waitsForTool;
const goesOn = () => page.getByRole("button", { name: "Continue", exact: true });

it("says that the controller waits for a tool, and what to do", async () => {
  controller.work("tool");
  await page.getByText("it waits for a tool: put it in, then press Continue").waitFor();
  await goesOn().waitFor();
  expect(await violations(page)).toEqual([]);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/tool-wait.png` });
});

it("jogs meanwhile, and the controller goes on waiting when the key is let go", async () => {
  await page.keyboard.press("k");
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  const far = (mm: number) => async () => ((await controller.look()).place[0] ?? 0) > mm;
  const keys = keysOf(page, ["ArrowRight"]);
  await hold(workshop, keys, far(3), "it jogs");
  await keys.up();
  await page.keyboard.press("Escape");
  await until(() => stands(workshop), "it stands");
  expect(await waits()).toBe(true);
  await until(() => goesOn().isVisible(), "the page says so still");
});

it("starts no file until the tool is in", async () => {
  expect(await script(workshop, "open", { name: "line.sbp" })).toBe(200);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "failed", "it is refused");
  const { job } = await stateOf(workshop);
  expect(job?.error?.message).toContain("waits for a tool");
  expect(await waits()).toBe(true);
});

it("goes on when Continue is pressed, and takes files again", async () => {
  await goesOn().click();
  await until(async () => !(await waits()), "the controller goes on");
  await until(async () => !(await stateOf(workshop)).machine.wantsTool, "the page knows");
  await act(page, "Acknowledge").catch(() => undefined);
  if (!(await stateOf(workshop)).machine.armed) await arm(page);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the file is cut");
  expect((await controller.look()).place[0]).toBeCloseTo(50.8, 2);
});

it("goes on in the middle of a job, which makes no jog of its moves", async () => {
  writeFileSync(join(workshop.parts, "paused.sbp"), "MX,1\nPAUSE 2\nMX,3\n");
  expect(await script(workshop, "open", { name: "paused.sbp" })).toBe(200);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(
    async () => Math.abs(((await controller.look()).place[0] ?? 0) - 25.4) < 0.01,
    "it pauses",
  );
  controller.work("tool");
  await goesOn().waitFor();
  await page.waitForTimeout(3000);
  expect((await controller.look()).place[0], "the job waits").toBeCloseTo(25.4, 2);
  await goesOn().click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the file is cut");
  expect((await controller.look()).place[0]).toBeCloseTo(76.2, 2);
});
