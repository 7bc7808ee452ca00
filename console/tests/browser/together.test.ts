/** Two machines in one server: each has a page, an owner and a STOP of its own. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import { Controller } from "./controller";
import { arm, openWorkshop, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;
let laser: string;

beforeAll(async () => {
  controller = new Controller();
  laser = `grbl:${await controller.port()}`;
  workshop = await openWorkshop({ also: [laser], isDeaf: true });
  writeFileSync(join(workshop.parts, "long.sbp"), "MS,.1\nMX,40\n");
  page = await workshop.page();
});
afterAll(async () => {
  await workshop?.close();
  controller?.unplug();
});

const machines = () => page.getByRole("navigation", { name: "Machines" });

/** State of the machine whose page is shown, as its server tells it. */
const here = async () =>
  (await (await fetch(new URL("/api/state", page.url()))).json()) as Snapshot;

async function starts(name: string): Promise<void> {
  await arm(page);
  const headers = { "content-type": "application/json" };
  const body = JSON.stringify({ name });
  await fetch(new URL("/api/do/open", page.url()), { method: "POST", headers, body });
  await expect.poll(async () => (await here()).opened?.preview.state).toBe("ready");
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await expect.poll(async () => (await here()).machine.state).toBe("running");
}

it("a page tells which machines there are and leads to the other one", async () => {
  expect(await machines().locator("[aria-current=page]").textContent()).toBe("sim");
  expect(await page.locator(".mode").textContent()).toContain("SIMULATED");
  expect(await violations(page)).toEqual([]);
  await starts("long.sbp");
  await machines().getByRole("link", { name: laser }).click();
  await page.locator(".mode", { hasText: "CUT" }).waitFor();
  expect(await machines().locator("[aria-current=page]").textContent()).toBe(laser);
  expect(new URL(page.url()).port).not.toBe(new URL(workshop.address).port);
});

it("STOP on the page of one stops that one alone", async () => {
  // The other machine is new: its page offers to set it up.
  const sheet = page.getByRole("dialog", { name: "Set up the machine" });
  await sheet.getByRole("button", { name: "Skip" }).click();
  await starts("long.sbp");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/together.png` });
  await until(async () => ((await controller.look()).place[0] ?? 0) > 0, "it moves");
  await page.getByRole("button", { name: "STOP" }).click();
  await expect.poll(async () => (await here()).machine.state).not.toBe("running");
  expect((await stateOf(workshop)).machine.state, "the other one goes on").toBe("running");
  await machines().getByRole("link", { name: "sim" }).click();
  await page.locator(".mode", { hasText: "SIMULATED" }).waitFor();
  await page.getByRole("button", { name: "STOP" }).click();
  await expect.poll(async () => (await stateOf(workshop)).machine.state).not.toBe("running");
  expect(workshop.mistakes).toEqual([]);
});
