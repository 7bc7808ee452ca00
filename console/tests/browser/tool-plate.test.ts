/** A change of tools with a loose plate: the contact is tried by hand, both tools touch the plate, and Z zero follows. */

import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { act, arm, script, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const change = "MS,4,4\nMZ,0.5\n&Tool = 2\nC9\nMZ,1\n";
  const shop = await driveController({ "change.sbp": change });
  ({ controller, workshop, page } = shop);
  await arm(page);
  return shop.close;
});

const zMm = async () => (await controller.look()).place[2] ?? 0;
const asks = (words: string) => page.getByText(words).first().waitFor();
const press = (name: string) => page.getByRole("button", { name, exact: true }).click();

/** The plate touches the tip by hand, and is laid below it, where the tip of the tool meets it at a height. */
async function tries(tipMm: number): Promise<void> {
  await asks("Hold the plate against the tip of the tool and press OK: input 1 has to be on.");
  await press("OK");
  await asks("Input 1 is off: look at the lead of the plate");
  controller.work("pins P");
  await page.waitForTimeout(500);
  await press("OK");
  await asks("The plate is felt. Lay it below the tool and press OK.");
  expect(await violations(page)).toEqual([]);
  controller.work("nothing");
  controller.work(`plate ${tipMm} 0 0`);
  controller.work("pins");
  await page.waitForTimeout(500);
  await press("OK");
}

it("is told the input of the plate", async () => {
  await act(page, "Tools by their numbers");
  const input = page.getByLabel("Input of a loose plate");
  await input.selectOption("1");
  await until(async () => (await input.inputValue()) === "1", "the setting is written");
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press("Escape");
});

it("measures the tool before the change and the one behind it, and Z zero follows", async () => {
  expect(await script(workshop, "open", { name: "change.sbp" })).toBe(200);
  await press("Start");
  await asks("Is the tool in the spindle with which Z zero was set?");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/plate-asked.png` });
  await press("Yes");
  await tries(-10);
  await asks("with the plate where it was and the lead on it, and press OK.");
  expect(await zMm(), "it is lifted off the plate").toBeGreaterThan(0);
  controller.work("nothing");
  await press("OK");
  await tries(-7);
  await asks("Take the plate and its lead away and press OK.");
  controller.work("nothing");
  await press("OK");
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the file is over");
  const { working } = (await stateOf(workshop)).motion.at;
  expect(working[2], "it stands at 1 inch").toBeCloseTo(25.4, 2);
  expect(await zMm(), "of a zero that is 3 mm higher").toBeCloseTo(28.4, 1);
});
