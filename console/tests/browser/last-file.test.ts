/** FP and FG without a name, and the picture of a program that asks. */

import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { PreviewInfo } from "../../src/wire/messages";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  location,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 20 });
  writes("last.sbp", "SA\nMX,2\nMX,3\n");
  writes("ask.sbp", 'SA\nINPUT "How deep?" &d\nMZ,-&d\nM2,2,2\n');
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(async () => {
  // A picture may be replaced by the next one while the page still fetches it.
  expect(workshop.mistakes.filter((words) => !words.includes("404"))).toEqual([]);
  await workshop.close();
});

const writes = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
const sheet = () => page.getByRole("dialog");
const file = () => sheet().getByRole("textbox").first();
const offered = () =>
  until(async () => (await file().inputValue()) === "last.sbp", "the last file is offered");
const reaches = (place: number) =>
  until(async () => (await location(page, "X")) === place, `X at ${place}`);
const idle = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "it stands");

it("sbp_file_fp_last: FP and ENTER offers the file that ran last, ENTER runs it", async () => {
  await carryOut(workshop, page, "FP,last.sbp");
  await carryOut(workshop, page, "MX,0");
  await command(page, "fp");
  await sheet().waitFor();
  await offered();
  await page.keyboard.press("Enter");
  await reaches(3);
  await idle();
  expect(await sheet().count()).toBe(0);
});

it("sbp_file_fp_last: the same with the sheets on, where another name may be typed", async () => {
  await carryOut(workshop, page, "MX,0");
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "always"));
  await page.reload();
  await arm(page);
  await page.getByLabel("Command line").pressSequentially("fp");
  await sheet().waitFor();
  await offered();
  await page.keyboard.insertText("ask.sbp");
  expect(await file().inputValue()).toBe("ask.sbp");
  await page.keyboard.press("Escape");
  await page.getByLabel("Command line").pressSequentially("fg");
  await sheet().waitFor();
  await offered();
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).asked?.kind === "step", "it is gone through");
  await script(workshop, "stop");
  await idle();
});

/** Opens the program that asks; how deep its picture goes. */
async function depth(): Promise<number> {
  await script(workshop, "open", { name: "last.sbp" });
  await script(workshop, "open", { name: "ask.sbp" });
  let low = Number.NaN;
  await until(async () => {
    const { opened } = await stateOf(workshop);
    const preview = opened?.name === "ask.sbp" ? opened.preview : undefined;
    if (preview?.state !== "ready") return false;
    const { address, shows: headers } = workshop;
    const answer = await fetch(`${address}/api/preview/${preview.key}`, { headers });
    const { bounds } = (await answer.json()) as PreviewInfo;
    low = bounds?.[0][2] ?? Number.NaN;
    return true;
  }, "it is previewed");
  return low;
}

it("sbp_file_check: a program that asks is drawn, with 0 and a note, else with the answers beside it", async () => {
  const easy = await workshop.page();
  const note = easy.getByText("nobody answers 'How deep?' here: 0 is taken");
  expect(await depth()).toBeCloseTo(0, 6);
  await easy.getByRole("radio", { name: "File", exact: true }).click();
  await note.first().waitFor();
  const status = easy.locator(".job-status");
  expect(await status.textContent()).not.toMatch(/mistake|ends at/);
  writes("ask.sbp.answers", "# how deep\n.5\n");
  try {
    await until(async () => Math.abs((await depth()) + 12.7) < 1e-6, "it is half an inch deep");
    await until(async () => (await note.count()) === 0, "the note is gone");
  } finally {
    rmSync(join(workshop.parts, "ask.sbp.answers"));
  }
});
