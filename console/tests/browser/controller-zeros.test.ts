import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { act, arm, stands, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController();
  ({ controller, workshop, page } = shop);
  return shop.close;
});

const working = async () => (await stateOf(workshop)).motion.at.working.slice(0, 3);
const row = (name: string) => page.getByRole("row").filter({ hasText: new RegExp(`^${name}[^.]`) });

/** X, Y and Z read these numbers, mm. */
const reads = (...places: number[]) =>
  until(async () => {
    const told = await working();
    return places.every((mm, axis) => Math.abs((told[axis] ?? 0) - mm) < 0.01);
  }, `the axes read ${places}`);

it("lists the zero points of the controller, G54 holds", async () => {
  await act(page, "Zero points of the controller");
  await page.getByRole("dialog", { name: "Zero points of the controller" }).waitFor();
  expect(await page.locator(".zeros tbody tr").count()).toBe(11);
  expect(await page.locator("tr[aria-current] th").textContent()).toBe("G54holds");
  expect(await violations(page)).toEqual([]);
});

it("changes none while the machine is disarmed", async () => {
  const use = page.getByRole("button", { name: "Use G55" });
  expect(await use.isDisabled()).toBe(true);
  await page.keyboard.press("Escape");
  await arm(page);
  await act(page, "Zero points of the controller");
  await use.waitFor();
  expect(await use.isDisabled()).toBe(false);
});

it("sets one to where the tool is, for the axes that are given", async () => {
  const form = page.getByRole("region", { name: "Set a zero point" });
  await form.getByLabel("X", { exact: true }).fill("1");
  await form.getByLabel("Z", { exact: true }).fill("-0.5");
  await form.getByRole("button", { name: "Set G54" }).click();
  await reads(25.4, 0, -12.7);
  const { zeros } = await stateOf(workshop);
  expect(zeros[0]?.at.slice(0, 3)).toEqual([-25.4, 0, 12.7]);
});

it("sets another by its place, and uses it", async () => {
  const form = page.getByRole("region", { name: "Set a zero point" });
  await form.getByLabel("Zero point").selectOption("G55");
  await form.getByRole("radio", { name: "It lies at, from home" }).click();
  await form.getByLabel("X", { exact: true }).fill("2");
  await form.getByLabel("Z", { exact: true }).fill("");
  await form.getByRole("button", { name: "Set G55" }).click();
  await until(async () => (await stateOf(workshop)).zeros[1]?.at[0] === 50.8, "it is written");
  await reads(25.4, 0, -12.7);
  await page.getByRole("button", { name: "Use G55" }).click();
  await reads(-50.8, 0, 0);
  expect(await page.locator("tr[aria-current] th").textContent()).toBe("G55holds");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/zeros.png` });
});

it("sees one that is set at a pendant, and clears the shift", async () => {
  controller.says("G10L2P2X76.2Y0Z0");
  await row("G55").getByText("3.000").waitFor();
  await reads(-50.8, 0, 0);
  await page.getByRole("button", { name: "Use G55" }).click();
  await reads(-76.2, 0, 0);
  controller.says("G92X0");
  await row("G92").getByText("-3.000").waitFor();
  await page.getByRole("button", { name: "Clear G92" }).click();
  await until(async () => (await stateOf(workshop)).zeros[9]?.at[0] === 0, "it is gone");
  await until(() => stands(workshop), "it stands");
  await reads(-76.2, 0, 0);
});
