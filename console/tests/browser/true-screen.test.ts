/** The screen tells nothing that is not so: of the file that is open, of what runs, of what was checked. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  fullFace,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

const bad = "SA\nM2,1,1\nM2,2,1\nFOO,1\nM2,2,2\nMX,\n";
const good = "SA\nMS,2,2\nM2,1,0\nM2,1,1\nM2,0,0\n";

beforeEach(async () => {
  workshop = await openWorkshop({ rate: 4 });
  writes("bad.sbp", bad);
  writes("good.sbp", good);
  writes("other.sbp", "SA\nM2,2,2\nM2,0,0\n");
  page = await workshop.page();
});
afterEach(async () => {
  expect(workshop.mistakes).toEqual([]);
  await workshop.close();
});

const writes = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);

async function opens(name: string): Promise<void> {
  await script(workshop, "open", { name });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, `${name} is previewed`);
}

const start = () => page.getByRole("button", { name: "Start", exact: true });
const status = () => page.locator(".job-status");
const bar = () => page.getByRole("progressbar", { name: "Progress" });
const part = async () => Number(await bar().getAttribute("value"));
const ends = () => until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is done");
const cursorLine = () => page.locator(".cm-activeLineGutter", { hasText: /\d/ }).textContent();

it("a file with mistakes looks like one, and Start leads to its first line", async () => {
  await opens("good.sbp");
  await start().click();
  await ends();
  await opens("bad.sbp");
  await status().filter({ hasText: "2 mistakes: see line 4" }).waitFor();
  expect(await part()).toBe(0);
  expect(await page.locator(".job-left").textContent()).toBe("–");
  await page.getByText("No tool path: 2 mistakes: see line 4.").waitFor();
  await page.locator(".words", { hasText: "unknown command FOO" }).waitFor();
  expect(await start().isDisabled()).toBe(true);
  await page.locator(".action-place", { has: start() }).click();
  await page.locator(".cm-content", { hasText: "FOO,1" }).waitFor();
  await expect.poll(cursorLine).toBe("4");
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByRole("button", { name: "No tool path: 2 mistakes: see line 4." }).click();
  await expect.poll(cursorLine).toBe("4");
  // The words beside the name of the file lead there too, and each finding to its own line.
  await page.getByRole("link", { name: "Operate" }).click();
  await status().click();
  await expect.poll(cursorLine).toBe("4");
  await page.getByLabel("Findings").getByRole("button", { name: "Line 6" }).click();
  await expect.poll(cursorLine).toBe("6");
});

it("a file whose preview ends at an error is ready with a word, and Start is not green", async () => {
  writes("late.sbp", "SA\nM2,1,1\nMZ,&nothing\nM2,0,0\n");
  await opens("late.sbp");
  await status().filter({ hasText: "its preview ends at line 3" }).waitFor();
  expect(await start().getAttribute("class")).not.toContain("button-go");
  await opens("good.sbp");
  await status().filter({ hasText: "ready" }).waitFor();
  expect(await start().getAttribute("class")).toContain("button-go");
});

it("finished is a file's own, and its bar is of what was done last", async () => {
  await opens("good.sbp");
  await status().filter({ hasText: "ready" }).waitFor();
  await start().click();
  await status().filter({ hasText: "running" }).waitFor();
  await ends();
  await page.locator(".job-spent", { hasText: /^took 0:0\d$/ }).waitFor();
  await status()
    .filter({ hasText: /^finished at \d\d:\d\d$/ })
    .waitFor();
  await expect.poll(part).toBe(1);
  await page.reload();
  await status()
    .filter({ hasText: /^finished at \d\d:\d\d$/ })
    .waitFor();
  await expect.poll(part).toBe(1);
  await opens("other.sbp");
  await status().filter({ hasText: "ready" }).waitFor();
  expect(await part()).toBe(0);
  await opens("good.sbp");
  await status()
    .filter({ hasText: /^finished at/ })
    .waitFor();
  expect(await part()).toBe(1);
  const desk = await commandDesk(workshop);
  await arm(desk);
  await carryOut(workshop, desk, "MX,.1");
  await status()
    .filter({ hasText: /^finished at/ })
    .waitFor();
  await expect.poll(part).toBe(0);
  writes("good.sbp", `${good}MX,1\n`);
  await opens("good.sbp");
  await status().filter({ hasText: "ready" }).waitFor();
});

it("a mistake that a run meets leads to its line, and so does the place where it failed", async () => {
  writes("meets.sbp", "SA\nM2,1,1\nPAUSE .1\nM2,&far,1\nM2,0,0\n");
  await opens("meets.sbp");
  await start().click();
  await until(async () => (await stateOf(workshop)).job?.ended === "failed", "it failed");
  await page.getByRole("radio", { name: "Messages" }).click();
  const said = page.locator(".words .word-error");
  await said.getByRole("button", { name: "Line 4", exact: true }).click();
  await expect.poll(cursorLine).toBe("4");
  await page.getByRole("link", { name: "Operate" }).click();
  await status()
    .filter({ hasText: /^failed behind line 2 at/ })
    .click();
  await expect.poll(cursorLine).toBe("2");
});

it("what runs beside the open file is named, and of an unknown plan no share is told", async () => {
  await opens("good.sbp");
  const desk = await commandDesk(workshop);
  await arm(desk);
  await carryOut(workshop, desk, "VS,1,1");
  await command(desk, "MX,20");
  const name = desk.locator(".job-name strong");
  await name.filter({ hasText: "MX,20" }).waitFor();
  expect(await desk.locator(".job-left").textContent()).toBe("–");
  await script(workshop, "stop");
  await until(async () => (await stateOf(workshop)).machine.state === "stopped", "stopped");
  await desk.getByRole("button", { name: "Quit" }).click();
  await name.filter({ hasText: "good.sbp" }).waitFor();
});

it("no mistakes are found only where all of the text was looked at", async () => {
  const said = page.getByLabel("Findings");
  writes("large.sbp", `FOO,1\n${"' a comment\n".repeat(260_000)}`);
  await opens("large.sbp");
  await page.getByRole("link", { name: "Edit" }).click();
  await page.locator(".cm-content", { hasText: "FOO,1" }).waitFor();
  // A saved file was looked at when it was opened.
  await said.getByText("unknown command FOO").waitFor();
  await page.locator(".cm-content").press("Control+Home");
  await page.keyboard.type("'");
  await said.getByText("Not checked: jumps, variables and units.").waitFor();
  expect(await said.getByText("No mistakes found").count()).toBe(0);
});

it("while a text is checked it says so, and where that fails why", async () => {
  const said = page.getByLabel("Findings");
  let answers = () => {};
  const asked = new Promise<void>((done) => {
    answers = done;
  });
  await page.route("**/api/language/check", async (route) => {
    await asked;
    await route.continue();
  });
  await opens("good.sbp");
  await page.getByRole("link", { name: "Edit" }).click();
  await page.locator(".cm-content", { hasText: "M2,1,0" }).waitFor();
  await said.getByText("Checking…").waitFor();
  expect(await said.getByText("No mistakes found").count()).toBe(0);
  answers();
  await said.getByText("No mistakes found.").waitFor();
  await page.unroute("**/api/language/check");
  const refusal = { status: 500, contentType: "application/json", body: '{"text":"it is busy"}' };
  await page.route("**/api/language/check", (route) => route.fulfill(refusal));
  await page.locator(".cm-content").press("Control+Home");
  await page.keyboard.type("'");
  await said.getByText("Not checked: it is busy.").waitFor();
  workshop.mistakes.length = 0;
});

it("one line is told everywhere: that of the move which the tool makes", async () => {
  const moves = Array.from({ length: 30 }, (_, n) => `M2,${n % 2},${n / 10}`);
  writes("many.sbp", `SA\nMS,1,1\n${moves.join("\n")}\n`);
  await opens("many.sbp");
  await fullFace(page);
  await arm(page);
  await start().click();
  await until(async () => (await stateOf(workshop)).motion.line >= 8, "it cuts");
  await script(workshop, "hold");
  await until(async () => (await stateOf(workshop)).machine.state === "held", "held");
  const { motion } = await stateOf(workshop);
  await status()
    .filter({ hasText: new RegExp(`^held, line ${motion.line}$`) })
    .waitFor();
  await page.locator(".job-spent", { hasText: /^so far 0:\d\d$/ }).waitFor();
  const listed = page.locator(".listing-running .listing-number");
  await expect.poll(() => listed.textContent()).toBe(`${motion.line}`);
  const head = page.getByRole("list", { name: "Files that run" });
  expect(await head.textContent()).toBe(`many.sbp line ${motion.line}`);
  await page.getByRole("link", { name: "Edit" }).click();
  const edited = page.locator(".cm-running");
  await expect.poll(() => edited.textContent()).toBe(moves[motion.line - 3]);
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByRole("button", { name: "Resume" }).click();
  await until(async () => (await stateOf(workshop)).motion.line > motion.line, "it goes on");
  await script(workshop, "stop");
  await until(async () => (await stateOf(workshop)).asked !== null, "it asks");
  const stopped = await stateOf(workshop);
  const told = `many.sbp, line ${stopped.asked?.line}`;
  await page.locator(".question-place", { hasText: told }).waitFor();
  expect(stopped.asked?.line).toBe(stopped.motion.line);
  await expect.poll(() => head.textContent()).toBe(told.replace(",", ""));
  await page.getByRole("button", { name: "Quit" }).last().click();
  await status()
    .filter({ hasText: /interrupted behind line \d+/ })
    .waitFor();
});

it("lengths are in the unit of the page, in sentences and for those who see no picture too", async () => {
  await opens("good.sbp");
  await page.getByLabel(/^Tool path of 3 moves, \d+ in of cuts$/).waitFor();
  await script(workshop, "draw", { op: { op: "do", clauses: "point 0,0; set black height=-13" } });
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Make the part program" }).click();
  const asks = page.getByRole("dialog").getByRole("textbox").first();
  await asks.fill("deep.sbp");
  await page.keyboard.press("Enter");
  const told = page.getByText(/it would be cut at -1\.2992 in, below ZBottom at -1\.1811 in/);
  await told.first().waitFor();
  expect(await page.getByText(/below ZBottom at -\d+ mm/).count()).toBe(0);
  workshop.mistakes.length = 0;
});
