/** Going line by line: to a breakpoint, in loops, in files that are called, on lines that do nothing. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

const main = [
  "SA",
  "&n = 0",
  "again:",
  "MX,&n",
  "&n = &n + 1",
  "IF &n < 3 THEN GOTO again",
  "",
  "MY,1",
  "FP,called.sbp",
  "MY,0",
];

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 20 });
  writeFileSync(join(workshop.parts, "main.sbp"), `${main.join("\n")}\n`);
  writeFileSync(join(workshop.parts, "called.sbp"), "MX,1\nMX,2\nMX,0\n");
  page = await workshop.page();
  await arm(page);
});
afterAll(() => workshop?.close());

const bar = () => page.getByRole("region", { name: "Line by line" });
const toBreakpoint = () => bar().getByRole("button", { name: "To breakpoint" }).click();
const stepButton = () => bar().getByRole("button", { name: "Step", exact: true });

/** Opens a file in the editor. */
async function edits(name: string): Promise<void> {
  await script(workshop, "open", { name });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, "previewed");
  await page.getByRole("link", { name: "Edit" }).click();
  await page.getByRole("heading", { name }).waitFor();
}

/** F9 in a line. */
async function toggles(line: number): Promise<void> {
  await page.locator(".cm-content").press("Control+Home");
  for (let n = 1; n < line; n += 1) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("F9");
}

/** It stands before a line, and steps on by itself no more. */
async function standsAt(line: number, file = "main.sbp"): Promise<void> {
  await stepButton().waitFor();
  const { asked } = await stateOf(workshop);
  expect([asked?.file, asked?.line]).toEqual([file, line]);
  await bar().getByText(`Line ${line}`, { exact: true }).waitFor();
}

async function begins(): Promise<void> {
  await page.getByRole("button", { name: "Go line by line" }).click();
  await stepButton().waitFor();
}

async function quits(): Promise<void> {
  await bar().getByRole("button", { name: "Quit" }).click();
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "over");
}

it("to breakpoint goes on over lines that move, round a loop and to the next one", async () => {
  await edits("main.sbp");
  await toggles(5);
  // Nothing is ever due at an empty line: the next one has it.
  await toggles(7);
  await page.getByText("Breakpoints: 5, 8").waitFor();
  await begins();
  await standsAt(1);
  for (const line of [5, 5, 5, 8]) {
    await toBreakpoint();
    await standsAt(line);
  }
  const { motion } = await stateOf(workshop);
  expect(motion.at.working[0]).toBeCloseTo(2 * 25.4, 3);
  // Behind the last one it runs to the end.
  await toBreakpoint();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is done");
  await bar().waitFor({ state: "detached" });
});

it("breakpoints belong to their files, and stay where the editor shows another screen", async () => {
  await toggles(5);
  await toggles(8);
  await page.getByText("sets a breakpoint").waitFor();
  await edits("called.sbp");
  await toggles(2);
  await edits("main.sbp");
  await page.getByText("Breakpoints: 2 of called.sbp").waitFor();
  await toggles(10);
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByRole("link", { name: "Edit" }).click();
  await page.locator(".cm-breakpoint:visible").first().waitFor();
  await begins();
  await toBreakpoint();
  await standsAt(2, "called.sbp");
  await toBreakpoint();
  await standsAt(10);
  await quits();
});

it("on the way it can be halted", async () => {
  await toggles(10);
  await page.getByText("Breakpoints: 2 of called.sbp").waitFor();
  writeFileSync(join(workshop.parts, "slow.sbp"), `SA\nMS,.2,.2\n${"MX,1\nMX,0\n".repeat(20)}`);
  await edits("slow.sbp");
  await toggles(40);
  await begins();
  await toBreakpoint();
  await bar().getByRole("button", { name: "Halt" }).click();
  await stepButton().waitFor();
  const { asked } = await stateOf(workshop);
  expect(asked?.line).toBeLessThan(40);
  await quits();
});
