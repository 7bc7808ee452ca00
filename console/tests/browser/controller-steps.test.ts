/** Steps a millimetre are written from the page into a pretended controller, and read back. */

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
  await act(page, "Steps per millimetre");
  await page.getByText("The controller keeps 250 steps a millimetre of X.").waitFor();
  return shop.close;
});

const steps = async () => (await stateOf(workshop)).controllerSteps;

it("writes nothing while the machine is disarmed", async () => {
  await page.getByLabel("Way to move").fill("4");
  await page.getByLabel("Way that was measured").fill("3.96");
  expect(await page.getByRole("button", { name: "Write the steps…" }).isDisabled()).toBe(true);
  await page.keyboard.press("Escape");
});

it("moves a way, writes $100 after a question, and shows what was read back", async () => {
  await arm(page);
  await act(page, "Steps per millimetre");
  await page.getByLabel("Way to move").fill("4");
  await page.getByRole("button", { name: "Move X so far" }).click();
  await until(async () => {
    const { machine, motion } = await stateOf(workshop);
    return machine.state === "idle" && Math.abs((motion.at.machine[0] ?? 0) - 101.6) < 0.01;
  }, "it has moved");
  await page.getByLabel("Way that was measured").fill("3.96");
  await page.getByRole("button", { name: "Write the steps…" }).click();
  expect(await controller.setting(100)).toBe(250);
  await page.getByRole("button", { name: "Write", exact: true }).click();
  await page.getByText("The controller keeps 252.525 steps a millimetre of X.").waitFor();
  expect(await controller.setting(100)).toBe(252.525);
  expect(await steps()).toEqual([252.525, 250, 250]);
  // It counts its steps: where it stands is another place by the new ones, and the page says it.
  await until(async () => {
    const x = (await stateOf(workshop)).motion.at.machine[0] ?? 0;
    return Math.abs(x - (101.6 * 250) / 252.525) < 0.01;
  }, "the page shows where it counts now");
  const { messages } = await stateOf(workshop);
  expect(messages.map(({ text }) => text).join()).toContain("it counts anew where X stands");
  expect(await violations(page)).toEqual([]);
});

it("moves as far as the new steps say", async () => {
  await page.getByLabel("Way to move").fill("1");
  const from = (await controller.look()).place[0] ?? 0;
  await page.getByRole("button", { name: "Move X so far" }).click();
  await until(async () => {
    const x = (await controller.look()).place[0] ?? 0;
    return Math.abs(x - from - 25.4) < 0.01;
  }, "it has moved an inch");
});
