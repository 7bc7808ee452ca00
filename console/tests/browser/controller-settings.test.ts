/** The settings of a controller on the page: found, changed, backed up, compared with a file and made as in it. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
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
  await act(page, "Settings of the controller");
  await sheet().waitFor();
  return shop.close;
});

const sheet = () => page.getByRole("dialog", { name: "Settings of the controller" });
const row = (number: number) =>
  sheet()
    .getByRole("row")
    .filter({ hasText: new RegExp(`^\\$${number} `) });
const stands = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "it stands");

it("lists what the controller keeps, with names and units, and finds by a word", async () => {
  await row(110).getByText("X greatest speed").waitFor();
  expect(await row(110).textContent()).toContain("mm/min");
  const all = await sheet().getByRole("row").count();
  await sheet().getByLabel("Find").fill("accel");
  expect(await sheet().getByRole("row").count()).toBeLessThan(all);
  await row(120).getByText("mm/s²").waitFor();
  await sheet().getByLabel("Find").fill("");
  expect(await violations(page)).toEqual([]);
});

it("tells what a setting does below it, and finds by that", async () => {
  const does = sheet().getByText(/^Decides how fast corners are taken/);
  expect(await does.count()).toBe(0);
  const name = row(11).getByRole("button", { name: "$11 junction deviation" });
  await name.click();
  await does.waitFor();
  expect(await name.getAttribute("aria-expanded")).toBe("true");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/explained.png` });
  await name.click();
  await does.waitFor({ state: "detached" });
  await sheet().getByLabel("Find").fill("corners");
  await does.waitFor();
  expect(await sheet().getByRole("row").count()).toBe(3);
  expect(await violations(page)).toEqual([]);
  await sheet().getByLabel("Find").fill("");
});

it("writes none while the machine is disarmed, and writes one that is read back", async () => {
  await row(120).getByRole("button", { name: "Change $120" }).click();
  const write = sheet().getByRole("button", { name: "Write", exact: true });
  expect(await write.isDisabled()).toBe(true);
  await page.keyboard.press("Escape");
  await arm(page);
  await act(page, "Settings of the controller");
  await row(120).getByRole("button", { name: "Change $120" }).click();
  await sheet().getByLabel("X acceleration").fill("321");
  await write.click();
  await row(120).getByText("321.000 mm/s²").waitFor();
  expect(await controller.setting(120)).toBe(321);
  await stands();
});

it("backs all of them up, and makes the controller as in the file again", async () => {
  const saved = page.waitForEvent("download");
  await sheet().getByRole("button", { name: "Back up" }).click();
  const kept = join(workshop.parts, "kept.txt");
  await (await saved).saveAs(kept);
  const text = readFileSync(kept, "utf8");
  expect(text).toMatch(/^\$120=321\.000$/m);
  writeFileSync(kept, text.replace("$120=321.000", "$120=500").replace(/^\$121=.*$/m, "$121=450"));
  const chooser = page.waitForEvent("filechooser");
  await sheet().getByRole("button", { name: "Compare with a file…" }).click();
  await (await chooser).setFiles(kept);
  const compared = sheet().getByRole("region", { name: "Compared with the file" });
  await compared.getByRole("row").nth(2).waitFor();
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/settings.png` });
  expect(await compared.getByRole("row").count()).toBe(3);
  expect(await violations(page)).toEqual([]);
  await compared.getByRole("button", { name: "Write the values of the file…" }).click();
  await compared.getByText("Write 2 settings into the controller?").waitFor();
  await compared.getByRole("button", { name: "Write", exact: true }).click();
  await compared.getByText("The controller has every value of the file.").waitFor();
  expect([await controller.setting(120), await controller.setting(121)]).toEqual([500, 450]);
});

it("tells why a value is refused", async () => {
  await stands();
  await row(22).getByRole("button", { name: "Change $22" }).click();
  await sheet().getByLabel("$22 homing", { exact: true }).fill("300");
  await sheet().getByRole("button", { name: "Write", exact: true }).click();
  await page.getByText("$22 is from 0 to 255").waitFor();
});
