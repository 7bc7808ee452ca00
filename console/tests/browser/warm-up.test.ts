/** The warm-up of the spindle on the page: steps changed and kept, the spindle on and off, STOP, refusals. */

import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import { driveController } from "./driven";
import { act, arm, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController();
  ({ workshop, page } = shop);
  await act(page, "Spindle warm-up");
  await sheet().waitFor();
  return shop.close;
});

const sheet = () => page.getByRole("dialog", { name: "Spindle warm-up" });
const field = (name: string) => sheet().getByRole("textbox", { name });
const start = () => sheet().getByRole("button", { name: "Start the warm-up" });
const machine = async () => (await stateOf(workshop)).machine.state;
const output = async () => (await stateOf(workshop)).io.outputs[0]?.on === true;
const standsWithSpindleOff = () =>
  until(async () => (await machine()) === "idle" && !(await output()), "it stands, spindle off");

it("begins with the steps of the settings, and not while the machine is disarmed", async () => {
  await expect.poll(() => field("Step 4, speed").inputValue()).toBe("100");
  await sheet().getByText("8 min in all").waitFor();
  expect(await start().isDisabled()).toBe(true);
  expect(await violations(page)).toEqual([]);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/warm-up.png` });
});

it("keeps other steps in the settings, and refuses what is no number", async () => {
  await page.keyboard.press("Escape");
  await arm(page);
  await act(page, "Spindle warm-up");
  for (const step of [4, 3]) {
    await sheet()
      .getByRole("button", { name: `Take step ${step} away` })
      .click();
  }
  await field("Step 1, time").fill("");
  expect(await start().isDisabled()).toBe(true);
  await field("Step 1, time").fill("0.03");
  await field("Step 2, speed").fill("80");
  await field("Step 2, time").fill("60");
  await sheet().getByRole("button", { name: "Keep these steps" }).click();
  await until(async () => {
    const areas = await (await fetch(`${workshop.address}/api/settings`)).text();
    return areas.includes('"25:0.03, 80:60"');
  }, "the steps are kept");
});

it("has the spindle turn in the steps, and STOP ends it with the spindle off", async () => {
  await start().click();
  await page
    .getByText(/step 1 of 2: 6000 rpm for 0.03 min, 60.03 min left/)
    .first()
    .waitFor();
  await page
    .getByText(/step 2 of 2: 19200 rpm for 60 min, 60 min left/)
    .first()
    .waitFor();
  await until(output, "the spindle turns");
  await sheet().getByRole("status", { name: "Pause" }).waitFor();
  await sheet().getByRole("button", { name: "End the warm-up" }).click();
  await start().waitFor();
  await standsWithSpindleOff();
});

it("ends by a hold as well, and is not taken up", async () => {
  await start().click();
  await until(output, "the spindle turns");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Hold" }).click();
  await standsWithSpindleOff();
  expect((await stateOf(workshop)).interrupted).toBeNull();
});

it("comes to its end with the spindle off", async () => {
  await act(page, "Spindle warm-up");
  await field("Step 2, time").fill("0.02");
  await start().click();
  await until(output, "the spindle turns");
  await standsWithSpindleOff();
});
