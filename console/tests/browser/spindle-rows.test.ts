/** Rows of the ledger about the spindle: its question, the flag behind it, its speed, and what preview leaves off. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  location,
  openWorkshop,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

const shots = process.env.KERF_SHOTS;
let workshop: Workshop;
let page: Page;

const files: Record<string, string> = {
  "start.sbp": "SO,1,1\nPAUSE\nMX,1\nSO,1,0\nSO,1,1\nMX,0\nPAUSE\n",
  "active.sbp": "SetSpindleStatus, 1\nSO,1,1\nPAUSE\n",
  "rests.sbp": "SetSpindleStatus, 1\nSetSpindleStatus, 0\nSO,1,1\nMX,1\n",
  "wrong.sbp": "SetSpindleStatus, 2\n",
  "mill.nc": "G20\nM3 S12000\nG1 X1 F60\nM0\nM5\nG1 X0\nM0\n",
  "look.sbp": 'SO,3,1\nPAUSE 300\nZX\nMX,1\nMSGBOX("Is it drawn?", OKCancel)\nMX,2\n',
};

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 20 });
  for (const [name, text] of Object.entries(files)) writeFileSync(join(workshop.parts, name), text);
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  await page.getByLabel("Command line").fill("");
});

const run = (line: string) => carryOut(workshop, page, line);
const dialog = () => page.getByRole("dialog");
const press = (name: string) => dialog().getByRole("button", { name, exact: true }).click();
const starts = () =>
  page.locator(".question-text", { hasText: "The spindle is about to start." }).waitFor();
const asksToGoOn = () => page.locator(".question-text", { hasText: "Continue?" }).waitFor();
const idle = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "the machine is idle");
/** Tells whether the light of an output is on, as it is shown; a question lies over it at times. */
const isLit = async (number: number) => {
  const look = await page
    .locator(".lamp-output")
    .nth(number - 1)
    .getAttribute("class");
  return (look ?? "").split(" ").includes("lamp-on");
};
const lit = (number: number, on: boolean) => expect.poll(() => isLit(number)).toBe(on);
/** The flag, as other programs read it. */
const status = async () => (await fetch(`${workshop.address}/api/registry/SpindleStatus`)).text();

it("sbp_io_spindle_dialog: Cancel leaves it off; OK starts it, sets the flag, and it asks no more", async () => {
  expect(await status()).toBe("0");
  await command(page, "FP,start.sbp");
  await starts();
  if (shots) await page.screenshot({ path: `${shots}/spindle.png` });
  await press("Cancel");
  await idle();
  expect([await status(), await isLit(1)]).toEqual(["0", false]);

  await command(page, "FP,start.sbp");
  await starts();
  await press("OK");
  await asksToGoOn();
  await lit(1, true);
  expect(await status()).toBe("1");
  await press("OK");
  // It was switched off and on again: the next question is the program's own.
  await asksToGoOn();
  await expect.poll(() => location(page, "X")).toBe(0);
  expect([await status(), await isLit(1)]).toEqual(["1", true]);
  await press("OK");
  await idle();
  await lit(1, false);
  expect(await status()).toBe("0");

  // Typed it asks as well, and what was answered holds while it turns.
  await command(page, "SO,1,1");
  await starts();
  await press("OK");
  await idle();
  await lit(1, true);
  expect(await status()).toBe("1");
  await run("SO,1,1");
  expect(await dialog().count()).toBe(0);
  await run("SO,1,0");
});

it("sbp_io_spindle_dialog: a setting switches the question off", async () => {
  const asking = async (yes: string) => {
    await page.getByRole("link", { name: "Settings" }).click();
    await page.getByLabel("Search settings").fill("ask_spindle");
    const choice = page.locator('.setting[data-key="ask_spindle"]');
    await choice.getByRole("radio", { name: yes }).click();
    const chosen = choice.getByRole("radio", { name: yes });
    await expect.poll(() => chosen.getAttribute("aria-checked")).toBe("true");
    await page.getByRole("link", { name: "Operate" }).click();
    await page.getByLabel("Command line").waitFor();
  };
  await asking("no");
  await run("SO,1,1");
  await lit(1, true);
  expect(await dialog().count()).toBe(0);
  await run("SO,1,0");
  await asking("yes");
  await command(page, "SO,1,1");
  await starts();
  await press("Cancel");
  await idle();
});

it("sbp_io_setspindle: 1 starts it without the question, 0 brings the question back, 2 is an error", async () => {
  await command(page, "FP,active.sbp");
  await asksToGoOn();
  await lit(1, true);
  expect(await status()).toBe("1");
  await press("OK");
  await idle();
  await command(page, "FP,rests.sbp");
  await starts();
  expect([await status(), await isLit(1)]).toEqual(["0", false]);
  await press("Cancel");
  await idle();
  await command(page, "FP,wrong.sbp");
  await page.getByText("must be 0 or 1").first().waitFor();
  await idle();
});

it("sbp_gcode_spindle: M3 asks and switches the output on, M5 off", async () => {
  await command(page, "FP,mill.nc");
  await starts();
  await press("Cancel");
  await idle();
  expect([await isLit(1), await location(page, "X")]).toEqual([false, 0]);
  await command(page, "FP,mill.nc");
  await starts();
  await press("OK");
  await dialog().getByRole("button", { name: "OK", exact: true }).waitFor();
  await expect.poll(() => location(page, "X")).toBe(1);
  await lit(1, true);
  if (shots) await page.screenshot({ path: `${shots}/mill.png` });
  await press("OK");
  await expect.poll(() => location(page, "X")).toBe(0);
  await lit(1, false);
  await press("OK");
  await idle();
});

it("sbp_cmd_sp_noeffect: in preview nothing is switched or waited for, questions come, and SM brings all back", async () => {
  await run("J2,3,0");
  await run("SP");
  const begun = Date.now();
  await command(page, "FP,look.sbp");
  // The pause alone is a quarter of a minute at this rate.
  await page.locator(".question-text", { hasText: "Is it drawn?" }).waitFor();
  expect(Date.now() - begun).toBeLessThan(10_000);
  expect(await isLit(3)).toBe(false);
  if (shots) await page.screenshot({ path: `${shots}/preview-asks.png` });
  await press("OK");
  await idle();
  await expect.poll(() => location(page, "X")).toBe(2);
  await run("SM");
  await expect.poll(() => location(page, "X")).toBe(3);
  await page.getByRole("radio", { name: "Base" }).click();
  await expect.poll(() => location(page, "X")).toBe(3);
  await page.getByRole("radio", { name: "Working" }).click();
  expect(await isLit(3)).toBe(false);
  await run("J2,0,0");
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
