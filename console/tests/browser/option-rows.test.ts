/** Rows of the ledger about options of the program: set on the page, offered, and kept. */

import type { Page } from "playwright-core";
import { afterAll, expect, it } from "vitest";
import { isMetric } from "../../src/units/quantity";
import { Sheet } from "./sheet";
import {
  arm,
  carryOut,
  commandDesk,
  openWorkshop,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
afterAll(() => workshop?.close());

/** The field of the joining distance on the page of settings. */
async function setting(page: Page) {
  await page.getByRole("link", { name: "Settings" }).click();
  await page.getByLabel("Search settings").fill("join_mm");
  return page.getByLabel("Options, join", { exact: true });
}

it("pro_options_join, pro_edit_join_default: the distance used last is offered next, and after a restart", async () => {
  workshop = await openWorkshop({ rate: 100 });
  const desk = await commandDesk(workshop);
  await arm(desk);
  await carryOut(workshop, desk, "VD,,,1");
  await until(async () => isMetric((await stateOf(workshop)).units), "millimetres");
  const field = await setting(desk);
  await field.fill("0.5");
  await field.press("Enter");
  await expect.poll(async () => (await stateOf(workshop)).drawing?.join ?? 0.5).toBe(0.5);
  await desk.getByRole("link", { name: "Draw", exact: true }).click();
  const sheet = new Sheet(workshop, desk);
  await sheet.scaled("line 0,0 10,0; line 10.6,0 20,0", 0.1, [10, 0]);
  const offered = desk.locator("#drawing-entry");
  const begin = async (...places: number[]) => {
    await sheet.tool("Join");
    for (const x of places) await sheet.click([x, 0]);
    await sheet.click([10, 8], "right");
    await offered.waitFor();
  };
  // Too far from each other for the distance that is set.
  await begin(5, 15);
  expect(await offered.inputValue()).toBe("0.5");
  await offered.press("Enter");
  await offered.waitFor({ state: "detached" });
  expect((await sheet.shapes()).length).toBe(4);
  await desk.getByRole("button", { name: "Select none" }).click();
  await begin(5, 15);
  await offered.fill("0.7");
  await offered.press("Enter");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(3);
  await sheet.tool("Join");
  await expect.poll(() => offered.inputValue()).toBe("0.7");
  await desk.keyboard.press("Escape");
  await expect.poll(async () => (await setting(desk)).inputValue()).toBe("0.7");
  await workshop.kill();
  workshop = await openWorkshop({ rate: 100, folder: workshop.parts });
  const again = await workshop.page();
  await expect.poll(async () => (await setting(again)).inputValue()).toBe("0.7");
});
