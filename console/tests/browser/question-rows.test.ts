/** Rows of the ledger about what the machine asks before it goes on, as it is asked and answered on the page. */

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

let workshop: Workshop;
let page: Page;

const files: Record<string, string> = {
  "pause.sbp": "PAUSE\nMX,1\n",
  "until.sbp": "'Close the clamp\nPAUSE UNTIL 5, 1\nMX,1\n",
  "limit.sbp": "MX,12\nMY,1\n",
  "part.xyz": "G20\nG1 X1 F60\n",
};

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
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
const asks = (words: string) => page.locator(".question-text", { hasText: words }).waitFor();
const idle = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "the machine is idle");
const x = () => location(page, "X");

it("sbp_flow_pause_plain: a box with OK and Cancel; Enter is OK, Cancel ends the file", async () => {
  await run("J2,0,0");
  await command(page, "FP,pause.sbp");
  await dialog().getByRole("button", { name: "Cancel", exact: true }).waitFor();
  await press("Cancel");
  await idle();
  expect(await x()).toBe(0);
  await command(page, "FP,pause.sbp");
  await dialog().getByRole("button", { name: "OK", exact: true }).waitFor();
  await page.keyboard.press("Enter");
  await expect.poll(x).toBe(1);
  await idle();
});

it("sbp_flow_pause_until: the comment above is shown; it goes on when the switch closes, or at OK", async () => {
  await run("J2,0,0");
  await command(page, "FP,until.sbp");
  await asks("Close the clamp");
  await dialog().getByRole("button", { name: "Inputs…" }).click();
  await page.getByRole("switch", { name: "Input 5", exact: true }).click();
  // Nobody presses anything in the question.
  await expect.poll(x).toBe(1);
  await idle();
  const clamp = page.getByRole("switch", { name: "Input 5", exact: true });
  if ((await clamp.count()) === 0)
    await page.getByRole("button", { name: "In", exact: true }).click();
  await clamp.click();
  await page.keyboard.press("Escape");
  await run("J2,0,0");
  await command(page, "FP,until.sbp");
  await asks("Close the clamp");
  await press("OK");
  await expect.poll(x).toBe(1);
  await idle();
});

it("sbp_val_vc_trigger_on: typed, it says that it is for part files", async () => {
  await command(page, "VC,,,,,,,,1,.05,.1,Z,8");
  await page.getByText("only in part files").first().waitFor();
  await idle();
});

it("sbp_conv_fc_unknown: it asks what a file is whose ending it does not know", async () => {
  await command(page, "FC,part.xyz");
  await asks("What is part.xyz?");
  const words = await dialog().textContent();
  for (const kind of ["DXF", "HPGL", "G-code", "bitmap"]) expect(words).toContain(kind);
  await dialog().getByLabel("Answer").fill("G-code");
  await page.keyboard.press("Enter");
  await idle();
});

it("sbp_lim_sf_dialog: a move beyond the limits offers Continue and End", async () => {
  await run("J2,0,0");
  await run("VL,0,10");
  await run("SF,1");
  const both = async () => [await x(), await location(page, "Y")];
  await command(page, "FP,limit.sbp");
  await press("Continue");
  await expect.poll(both).toEqual([12, 1]);
  await idle();
  await run("J2,0,0");
  await command(page, "FP,limit.sbp");
  await press("End");
  await until(async () => (await stateOf(workshop)).job?.ended === "limit", "the file is ended");
  expect(await both()).toEqual([0, 0]);
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
