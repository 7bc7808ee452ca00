import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import {
  arm,
  command,
  fullFace,
  location,
  openWorkshop,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({
    parts: ["01-first-cut/first-cut.sbp"],
    open: "first-cut.sbp",
    rate: 20,
  });
  writeFileSync(join(workshop.parts, "keypad.sbp"), "SK\nMX,1\nEND\n");
  page = await workshop.page();
  await arm(page);
});
afterAll(() => workshop?.close());

const ready = () => page.locator(".state", { hasText: "Ready" }).waitFor();

it("sbp_con_easy: every button shows the command that does the same, and does it", async () => {
  const easy = page.getByRole("navigation", { name: "EASY" }).getByRole("button");
  const buttons = await easy.allTextContents();
  expect(buttons).toEqual([
    "Move toolSK",
    "Zero X YZ2",
    "Zero ZZZ",
    "Work zeroJH",
    "Choose fileFP",
    "Cut partFP",
    "PreviewSP",
    "ToolsTD … TU",
    "Single stepFG",
    "SettingsVD",
  ]);
  await page.getByRole("button", { name: /^Zero X Y/ }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Zero X and Y" }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is zeroed");
  // The command is done; the file that is open is not.
  expect(await page.locator(".job-name", { hasText: "finished" }).count()).toBe(0);
  await ready();
});

it("sbp_con_status_panel: shows the speeds and switches absolute and relative", async () => {
  const cells = await page.locator(".status-speeds td").allTextContents();
  expect(cells.filter((text) => /^\d+\.\d\d$/.test(text))).toHaveLength(4);
  await page.getByRole("radio", { name: "Relative" }).click();
  await until(
    async () => page.getByRole("radio", { name: "Relative" }).isChecked(),
    "relative distances",
  );
  await ready();
  await page.getByRole("radio", { name: "Absolute" }).click();
  await until(
    async () => page.getByRole("radio", { name: "Absolute" }).isChecked(),
    "absolute distances",
  );
  await ready();
});

it("sbp_con_fillin_tips: names and values are explained", async () => {
  await fullFace(page);
  await page.getByLabel("Command line").pressSequentially("cc");
  const sheet = page.getByRole("dialog", { name: /CC/ });
  await sheet.waitFor();
  const tips = await sheet
    .locator(".sheet-fields > [title]")
    .evaluateAll((fields) => fields.map((field) => field.getAttribute("title") ?? ""));
  expect(tips.filter((tip) => tip !== "").length).toBeGreaterThan(3);
  expect(await sheet.locator(".field-hint", { hasText: "default" }).count()).toBeGreaterThan(3);
  await page.keyboard.press("Escape");
});

it("sbp_con_file_fillin: a chosen file asks for its parameters, with Cut, Preview and Single step", async () => {
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: /first-cut/ }).click();
  const sheet = page.getByRole("dialog", { name: /FP/ });
  await sheet.waitFor();
  expect(await sheet.locator(".sheet-fields > div").count()).toBeGreaterThanOrEqual(9);
  for (const name of ["Cut", "Preview", "Single step"]) {
    await sheet.getByRole("button", { name, exact: true }).waitFor();
  }
  await page.keyboard.press("Escape");
});

it("sbp_con_keypad_file: SK in a part file waits with the keypad until ESC", async () => {
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "never"));
  await command(page, "fp,keypad.sbp");
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  expect(await location(page, "X")).not.toBe(1);
  await page.keyboard.press("Escape");
  await until(async () => (await location(page, "X")) === 1, "the file goes on to X 1");
  await ready();
});
