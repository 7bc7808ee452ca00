/** The probe on a pretended controller: a bore and a corner at known places, and what is told without a contact. */

import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { act, arm, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController();
  ({ controller, workshop, page } = shop);
  await arm(page);
  await act(page, "Probe: find a place");
  await page.getByRole("dialog", { name: "Probe" }).waitFor();
  return shop.close;
});

const startButton = () => page.getByRole("button", { name: "Start probing" });

/** Makes the program of a kind with these entries. */
async function make(kind: string, entries: Record<string, string>): Promise<void> {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  await page.getByRole("radio", { name: kind }).click();
  for (const [name, text] of Object.entries(entries)) await page.getByLabel(name).fill(text);
  await page.getByRole("button", { name: "Make the program" }).click();
  await until(async () => {
    const { opened, job } = await stateOf(workshop);
    if ((job?.run ?? 0) <= before) return false;
    return job?.ended === "ok" && opened?.name === "probe.nc" && opened.preview.state === "ready";
  }, "it is made and drawn");
}

/** Starts it and waits for its end: its word. */
async function probe(): Promise<string> {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  await startButton().click();
  let ended: string | null = null;
  await until(async () => {
    const { job } = await stateOf(workshop);
    if ((job?.run ?? 0) > before) ended ??= job?.ended ?? null;
    return ended !== null;
  }, "it is over");
  return ended ?? "";
}

const working = async () => (await stateOf(workshop)).motion.at.working.slice(0, 3);

const speeds = { "First touch, a second": "0.2", "Second touch, a second": "0.02" };

it("moves nothing before the probe was seen to close and to open", async () => {
  await make("Bore", { "Probe, diameter": "0.25", Clearance: "0.04", ...speeds });
  await page.getByText("its input 1 has to close").waitFor();
  expect(await startButton().count()).toBe(0);
  controller.work("pins P");
  await page.getByText("Input 1 is closed").waitFor();
  expect(await startButton().count()).toBe(0);
  controller.work("pins ");
  await startButton().waitFor();
  expect(await violations(page)).toEqual([]);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/probe.png` });
});

it("tells that nothing was touched, and sets nothing", async () => {
  await page.getByLabel("Travel").fill("0.25");
  await make("Bore", {});
  expect(await probe()).toBe("failed");
  await page.getByText("Nothing was set.").waitFor();
  const [x = 0] = await working();
  expect(x).toBeCloseTo(6.35, 2);
});

it("finds the middle of a bore to 0.01 mm, which becomes zero", async () => {
  controller.work("bore 9.2 -2.1 8");
  await make("Bore", { Travel: "1" });
  expect(await probe()).toBe("ok");
  await page.getByRole("dialog").getByText("Probed: X").waitFor();
  const [x = 9, y = 9] = await working();
  const { place } = await controller.look();
  expect(Math.hypot(x, y)).toBeLessThan(0.01);
  expect(Math.hypot((place[0] ?? 0) - 9.2, (place[1] ?? 0) + 2.1)).toBeLessThan(0.01);
});

it("finds a corner to 0.01 mm in X, Y and Z", async () => {
  const { place } = await controller.look();
  const [x0 = 0, y0 = 0, z0 = 0] = place;
  controller.work("nothing");
  controller.work(`block ${x0 - 5} ${y0 - 6} -40 ${x0 + 90} ${y0 + 90} ${z0 - 3}`);
  await make("Outside corner", { Inset: "0.3", Depth: "0.1" });
  expect(await probe()).toBe("ok");
  const [x = 9, y = 9, z = 9] = await working();
  expect([x - (5 - 3.175), y - (6 - 3.175), z - 1.016].every((off) => Math.abs(off) < 0.01)).toBe(
    true,
  );
});
