/** The start-up line of the handbooks, `kerf sb3 LINE --console`: what its page shows, what it refuses. */

import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import { arm, command, location, openWorkshop, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;

afterEach(() => workshop?.close());

/** Starts with a line whose file is a.sbp; its page. */
async function started(items: string, text = "MX,2\nMY,1\nEND\n"): Promise<Page> {
  const folder = mkdtempSync(join(tmpdir(), "kerf-console-"));
  writeFileSync(join(folder, "a.sbp"), text);
  workshop = await openWorkshop({ line: `a.sbp${items}`, folder, rate: 20 });
  const page = await workshop.page();
  return shown(page);
}

async function shown(page: Page): Promise<Page> {
  await page.locator(".mode").waitFor();
  return page;
}

const sheet = (page: Page) => page.getByRole("dialog", { name: /^FP/ });
const chip = (page: Page, words: string) => page.locator(".mode", { hasText: words });
const line = (page: Page) => page.getByLabel("Command line");
const easy = (page: Page) => page.getByRole("navigation", { name: "EASY" });
const is = (words: string, holds: (now: Snapshot) => boolean) =>
  until(async () => holds(await stateOf(workshop)), words);
const done = (words: string) =>
  is(`${words} is done`, ({ job, machine }) => job?.ended === "ok" && machine.state === "idle");

/** The beginning of the system log: with a file or not, the mode, and the items that were given. */
const logged = () =>
  readFileSync(join(workshop.parts, "SbSys.log"), "utf8").split(",").slice(0, 7).join(",");

/** The sheet is there with the file, and nothing has begun. */
async function waitsAtSheet(page: Page) {
  await sheet(page).waitFor();
  expect(await sheet(page).getByRole("textbox").first().inputValue()).toBe("a.sbp");
  expect(await location(page, "X")).toBe(0);
  expect((await stateOf(workshop)).machine.state).toBe("idle");
}

async function pressesCut(page: Page) {
  await arm(page);
  await sheet(page).getByRole("button", { name: "Cut" }).click();
  await is("the file was taken", ({ job }) => job?.command === "FP,a.sbp");
  await done("FP");
}

it("sbp_ctl_sb3_open1: the FP sheet waits in MOVE mode, OK moves the machine", async () => {
  const page = await started(",,1");
  await waitsAtSheet(page);
  await chip(page, "SIMULATED").waitFor();
  expect((await stateOf(workshop)).job).toBe(null);
  expect(logged()).toBe("StartFile,CUT,,1,,,");
  await pressesCut(page);
  await expect.poll(() => location(page, "X")).toBe(2);
});

/** Open 2, and 3 that is the same. */
async function opensInPreview(open: number) {
  const page = await started(`,,${open}`);
  await chip(page, "PREVIEW").waitFor();
  await waitsAtSheet(page);
  expect(logged()).toBe(`StartFile,PREVIEW,,${open},,,`);
  await pressesCut(page);
  await chip(page, "PREVIEW").click();
  await chip(page, "SIMULATED").waitFor();
  await expect.poll(() => location(page, "X")).toBe(0);
}

it("sbp_ctl_sb3_open2: the FP sheet waits in PREVIEW mode, OK only draws", () => opensInPreview(2));

it("sbp_ctl_sb3_open3: the same as 2", () => opensInPreview(3));

it("sbp_ctl_sb3_open6: nothing runs; the sheet of FP names the file", async () => {
  const page = await started(",,6");
  await page.locator(".job-name", { hasText: "a.sbp" }).waitFor();
  expect(await sheet(page).count()).toBe(0);
  expect((await stateOf(workshop)).job).toBe(null);
  expect(logged()).toBe("StartFile,CUT,,6,,,");
  await page.getByRole("radio", { name: "FULL" }).click();
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "always"));
  await page.reload();
  await line(page).pressSequentially("fp");
  await sheet(page).waitFor();
  expect(await sheet(page).getByRole("textbox").first().inputValue()).toBe("a.sbp");
  expect(await location(page, "X")).toBe(0);
});

it("sbp_ctl_sb3_close0: after the file the console is served on", async () => {
  const page = await started(",,4,,0");
  await done("the file");
  await expect.poll(() => location(page, "X")).toBe(2);
  await page.reload();
  await shown(page);
  await page.getByRole("radio", { name: "FULL" }).click();
  await arm(page);
  await command(page, "MX,3");
  await expect.poll(() => location(page, "X")).toBe(3);
});

it("sbp_ctl_sb3_display0: the console is as it was last used", async () => {
  const first = await started(",,6,,,0");
  await easy(first).waitFor();
  await first.getByRole("radio", { name: "FULL" }).click();
  await line(first).waitFor();
  const storageState = await first.context().storageState();
  const { parts: folder, address } = workshop;
  await workshop.kill();
  const listen = new URL(address).host;
  workshop = await openWorkshop({ line: "a.sbp,,6,,,0", folder, listen });
  const page = await workshop.browser.newPage({ storageState });
  await page.goto(address);
  await shown(page);
  await line(page).waitFor();
  expect(await easy(page).count()).toBe(0);
});

it("sbp_ctl_sb3_display1: the console is on", async () => {
  const page = await started(",,4,,,1");
  await line(page).waitFor();
  await page.evaluate(() => localStorage.setItem("kerf.face", "easy"));
  await page.reload();
  await line(page).waitFor();
  expect(await easy(page).count()).toBe(0);
});

it("sbp_ctl_sb3_display2: the console is off, and can be shown again", async () => {
  const page = await started(",,4,,,2");
  await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
  await page.reload();
  await easy(page).waitFor();
  expect(await line(page).count()).toBe(0);
  await page.getByRole("radio", { name: "FULL" }).click();
  await line(page).waitFor();
});

it("a sheet that was put away stays away: on a reload, on a second page, on one that shows it too", async () => {
  const page = await started(",,1");
  await waitsAtSheet(page);
  await page.reload();
  await waitsAtSheet(page);
  const other = await shown(await workshop.page());
  await waitsAtSheet(other);
  await page.keyboard.press("Escape");
  await is("it is put away", ({ start }) => start?.sheet === false);
  await sheet(other).waitFor({ state: "detached" });
  for (const one of [page, other]) {
    await one.reload();
    await shown(one);
    await one.locator(".job-name", { hasText: "a.sbp" }).waitFor();
    expect(await sheet(one).count()).toBe(0);
  }
});

it("a file below the part folder is named from there, commas and all", async () => {
  const folder = mkdtempSync(join(tmpdir(), "kerf-console-"));
  mkdirSync(join(folder, "doors"));
  writeFileSync(join(folder, "doors", "a, b.sbp"), "MX,2\nEND\n");
  workshop = await openWorkshop({ line: '"doors/a, b.sbp",,4', folder, rate: 20 });
  await done("the file");
  const page = await shown(await workshop.page());
  await expect.poll(() => location(page, "X")).toBe(2);
  await page.locator(".job-name", { hasText: "doors/a, b.sbp" }).waitFor();
});

/** Goes an inch further each time; from the second time on it waits there. */
const further = "&n = %(1) + 1\nMX,&n\nIF &n < 2 THEN GOTO DONE\nPAUSE 6000\nDONE:\nEND\n";

/** Answer of the server to a script, past every page. */
async function refusal(act: string, body: object): Promise<string> {
  const init = {
    method: "POST",
    headers: { "content-type": "application/json" },
    body: JSON.stringify(body),
  };
  return (await fetch(`${workshop.address}/api/do/${act}`, init)).text();
}

it("sbp_ctl_sb3_display9: no commands, no keypad; only file runs and Stop", async () => {
  const page = await started(",,4,,,9", further);
  await done("the file");
  await expect.poll(() => location(page, "X")).toBe(1);
  expect((await line(page).count()) + (await easy(page).count())).toBe(0);
  await arm(page);
  await chip(page, "SIMULATED").click();
  await page.getByText("started for files only").first().waitFor();
  await page.keyboard.press("k");
  await page.getByText("there is no keypad").waitFor();
  expect(await page.getByRole("dialog", { name: "Keypad" }).count()).toBe(0);
  for (const text of ["MX,5", "SK", "FP,a.sbp\nMX,5"]) {
    expect(await refusal("command", { lease: 0, line: text })).toContain("started for files only");
  }
  await is("it stands", ({ machine }) => machine.state === "idle" && machine.mode === "simulated");
  expect(await location(page, "X")).toBe(1);
  await page.getByRole("button", { name: /Start|Cut part/ }).click();
  await expect.poll(() => location(page, "X")).toBe(2);
  await page.getByRole("button", { name: "STOP" }).click();
  await is("it is stopped", ({ machine }) => machine.state === "stopped");
});
