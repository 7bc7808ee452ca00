/** Rows of the manual about files at the console: choosing, editing, facts in their heads. */

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
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

const place = (name: string) => join(workshop.parts, name);
const file = (name: string, text: string) => writeFileSync(place(name), text);

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  file("dos.sbp", "'a comment\r\nMX,1\r\nEND\r\n");
  file("a.sbp", "MX,2\nEND\n");
  file("notes.txt", "put the clamps on\n");
  file("waits.sbp", "FE,notes.txt\nMX,1\nEND\n");
  file("door.sbp", "'Contact: Ann\n'Material: birch, 18 mm\n\nMX,3\nEND\n");
  mkdirSync(place("x"));
  file("x/in.sbp", "MX,4\nEND\n");
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

const text = () => page.locator(".cm-content");
const title = () => page.getByRole("heading", { level: 1 }).textContent();
const ended = (line: string) =>
  until(async () => {
    const { job, machine } = await stateOf(workshop);
    return job?.command === line && job.ended === "ok" && machine.state === "idle";
  }, `${line} is done`);

beforeEach(async () => {
  if (!page.url().endsWith("/")) await page.getByRole("link", { name: "Operate" }).click();
  await page.getByLabel("Command line").fill("");
});

it("sbp_file_fe_last: FE opens an empty page at first, later the file that FP ran", async () => {
  await command(page, "FE");
  await text().waitFor();
  expect(await title()).toBe("New file");
  expect((await text().textContent())?.trim()).toBe("");
  await page.getByRole("link", { name: "Operate" }).click();
  await carryOut(workshop, page, "FP,a.sbp");
  await command(page, "FE");
  await text().filter({ hasText: "MX,2" }).waitFor();
  expect(await title()).toBe("a.sbp");
});

it("sbp_file_fe: FE with a name opens it, coloured; what is saved has the line ends it had", async () => {
  await command(page, "FE,dos.sbp");
  await text().filter({ hasText: "a comment" }).waitFor();
  const colours = await text()
    .locator(".cm-line span")
    .evaluateAll((spans) => spans.map((span) => getComputedStyle(span).color));
  expect(new Set(colours).size, "comments and commands differ").toBeGreaterThan(1);
  await text().click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("'more");
  await page.keyboard.press("Control+s");
  await expect
    .poll(() => readFileSync(place("dos.sbp"), "utf8"))
    .toBe("'a comment\r\nMX,1\r\nEND\r\n'more");
});

it("sbp_file_fn: FN opens an empty page, which asks for its name and becomes a .sbp", async () => {
  await command(page, "FN");
  await text().waitFor();
  await expect.poll(title).toBe("New file");
  await text().click();
  await page.keyboard.type("MX,1");
  expect(await title()).toBe("New file · not saved");
  await page.keyboard.press("Control+s");
  await page.getByRole("dialog", { name: "Save as" }).waitFor();
  await page.keyboard.type("fresh");
  await page.keyboard.press("Enter");
  await expect.poll(title).toBe("fresh.sbp");
  expect(readFileSync(place("fresh.sbp"), "utf8")).toBe("MX,1");
});

it("sbp_file_fe_infile: a program shows a file and goes on when the editor is closed", async () => {
  await carryOut(workshop, page, "MX,0");
  await command(page, "FP,waits.sbp");
  const bar = page.getByRole("region", { name: "The program waits" });
  await bar.waitFor();
  await text().filter({ hasText: "put the clamps on" }).waitFor();
  expect((await stateOf(workshop)).motion.at.working[0]).toBe(0);
  // Whoever loads the page again finds the same.
  await page.reload();
  await bar.waitFor();
  await text().filter({ hasText: "put the clamps on" }).waitFor();
  // Who comes again looks first: going on takes control and an armed machine.
  await bar.getByRole("note").getByRole("button").click();
  await bar.getByRole("note").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Done, go on" }).click();
  await ended("FP,waits.sbp");
  await page.getByRole("link", { name: "Operate" }).click();
  await expect.poll(() => location(page, "X")).toBe(1);
});

it("sbp_file_fp_headerinfo: a mark in the sheet of FP tells what the head of the file says", async () => {
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: "door.sbp" }).getByLabel("Its head tells").waitFor();
  expect(
    await page.getByRole("option", { name: "a.sbp", exact: true }).getByLabel("Its head").count(),
  ).toBe(0);
  await page.getByRole("option", { name: "door.sbp" }).click();
  const sheet = page.getByRole("dialog", { name: /^FP/ });
  const mark = sheet.getByRole("button", { name: "What the head of the file tells" });
  await mark.click();
  await sheet.getByText("Material: birch, 18 mm").waitFor();
  await sheet.getByRole("textbox", { name: /^File/ }).fill("a.sbp");
  await mark.waitFor({ state: "detached" });
  await page.keyboard.press("Escape");
});

it("sbp_file_fs_dialog: a folder that was chosen in the dialog stays, and UV shows it", async () => {
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: /^x\b/ }).click();
  await page.getByRole("option", { name: "in.sbp" }).click();
  await page.getByRole("dialog", { name: /^FP/ }).getByRole("button", { name: "Cut" }).click();
  await ended("FP,in.sbp");
  await expect.poll(() => location(page, "X")).toBe(4);
  await command(page, "UV");
  const row = page.getByRole("row", { name: /Part folder/ });
  await row.waitFor();
  expect(await row.textContent()).toContain("x");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+o");
  await page.getByRole("dialog", { name: "Part folder / x" }).waitFor();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
});

it("logs that lie beside part files are shown to a mask that asks for them", async () => {
  file("x/in.log", "log");
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: "in.sbp" }).waitFor();
  expect(await page.getByRole("option", { name: "in.log" }).count()).toBe(0);
  await page.keyboard.type("*");
  await page.getByRole("option", { name: "in.log" }).waitFor();
  await page.keyboard.press("Escape");
});
