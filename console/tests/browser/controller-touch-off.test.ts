/** Tools that a controller of grblHAL touches off by itself ($TPW) while it waits for them. */

import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { arm, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController({}, "hal", "341=1");
  ({ controller, workshop, page } = shop);
  await arm(page);
  return shop.close;
});

const button = (name: string) => page.getByRole("button", { name, exact: true });
const waits = async () => (await controller.look()).waitsForTool;
const zMm = async () => (await controller.look()).place[2] ?? 0;
const readsZ = async () => (await stateOf(workshop)).motion.at.working[2] ?? 0;
const says = (words: string | RegExp) => page.getByText(words).first().waitFor();

/** The controller begins to change the tool, with a plate at a height below it. */
async function changes(plateMm?: number): Promise<void> {
  controller.work("nothing");
  if (plateMm !== undefined) controller.work(`plate ${plateMm} 0 0`);
  controller.work("tool");
  await says("put it in and touch it off, then press Continue");
}

/** The tool that is in is touched off, and the plate taken away. */
async function touches(): Promise<void> {
  await button("Touch off").click();
  await says("the tool is touched off: take the plate away, then press Continue");
}

async function goesOn(): Promise<void> {
  await button("Continue").click();
  await until(async () => !(await waits()), "the controller goes on");
  await until(async () => !(await stateOf(workshop)).machine.wantsTool, "the page knows");
}

it("touches the first tool off, which is the reference of the others", async () => {
  await changes(-10);
  expect(await violations(page)).toEqual([]);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/touch-off.png` });
  await touches();
  await until(async () => Math.abs((await zMm()) + 6) < 0.6, "it is off the plate");
  await says("set Z zero with it, the next ones are measured against it");
  await goesOn();
  expect(await readsZ()).toBeCloseTo(await zMm(), 2);
  await button("Touch off").waitFor({ state: "detached" });
});

it("has Z zero follow the length of the next tool", async () => {
  await changes(-7.5);
  await touches();
  await says(/Z zero is 0\.09\d* in higher/);
  await until(
    async () => Math.abs((await zMm()) - (await readsZ()) - 2.5) < 0.05,
    "Z reads 2.5 mm less",
  );
  await goesOn();
});

it("does not go on before, and tells that nothing was touched", async () => {
  await changes();
  await button("Continue").click();
  await page.waitForTimeout(600);
  expect(await waits()).toBe(true);
  await button("Touch off").click();
  await says("the tool has touched nothing: bring it nearer to the plate");
  expect(await waits()).toBe(true);
});

it("is stopped on its way to the plate, and the change is given up", async () => {
  const before = await zMm();
  await button("Touch off").click();
  await until(async () => (await zMm()) < before - 2, "it goes down");
  await button("STOP").click();
  await says("it has given the change of tools up");
  expect(await waits()).toBe(false);
  const stood = await zMm();
  expect(stood).toBeGreaterThan(before - 29);
  await page.waitForTimeout(300);
  expect(await zMm()).toBe(stood);
});
