/**
 * Status of the open file: its last run, also after a restart and by a typed line; the time that a run
 * takes yet.
 */

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { arm, command, fullFace, openWorkshop, type Workshop } from "./workshop";

let folder: string;
let workshop: Workshop;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), "kerf-ran-"));
  writeFileSync(join(folder, "a.sbp"), "SA\nMS,2\nMX,1\nMX,0\nEND\n");
  writeFileSync(join(folder, "long.sbp"), "SA\nMS,1\nMX,40\nEND\n");
});
afterEach(async () => {
  await workshop?.close();
  rmSync(folder, { recursive: true, force: true });
});

const finished = (page: Page) =>
  page
    .getByText(/finished at \d\d:\d\d/)
    .first()
    .waitFor();

it("tells when a file was finished, also after the server was ended and begun again", async () => {
  workshop = await openWorkshop({ folder, open: "a.sbp", rate: 50 });
  const page = await workshop.page();
  await page.getByRole("button", { name: "Start" }).click();
  await finished(page);
  await workshop.kill();
  workshop = await openWorkshop({ folder, open: "a.sbp" });
  const again = await workshop.page();
  await finished(again);
});

it("tells that a file was finished which a typed line ran", async () => {
  workshop = await openWorkshop({ folder, open: "a.sbp", rate: 50 });
  const page = await workshop.page();
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "never"));
  await page.reload();
  await fullFace(page);
  await arm(page);
  await command(page, "FP,a.sbp");
  await finished(page);
});

it("tells the time that is left of whoever waits", async () => {
  workshop = await openWorkshop({ folder, open: "long.sbp", rate: 4 });
  const page = await workshop.page();
  const times = page.locator(".job-times span").last();
  const seconds = async (): Promise<number> =>
    ((await page.locator(".job-left").textContent()) ?? "")
      .split(":")
      .reduce((sum, part) => sum * 60 + Number.parseFloat(part), 0);
  await times.filter({ hasText: /planned \d/ }).waitFor();
  const planned = await seconds();
  expect(planned).toBeGreaterThan(20);
  await page.getByRole("button", { name: "Start" }).click();
  await times.filter({ hasText: /left \d/ }).waitFor();
  expect(await seconds()).toBeLessThanOrEqual(planned / 4 + 1);
});
