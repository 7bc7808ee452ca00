/** No file is replaced without a question; what was replaced comes back. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { openWorkshop, script, stateOf, tabTo, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeEach(async () => {
  workshop = await openWorkshop({ rate: 100 });
});
afterEach(() => workshop?.close());

const old = "'By hand\nMX,1\nMX,2\n";

const put = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
const read = (name: string) => readFileSync(join(workshop.parts, name), "utf8");

/** A page with a circle on the sheet. */
async function drawn(): Promise<Page> {
  const page = await workshop.page();
  await page.getByRole("link", { name: "Draw" }).click();
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 0,0 10" } });
  await until(async () => (await stateOf(workshop)).drawing?.shapes === 1, "a circle is drawn");
  return page;
}

const question = (page: Page, name: string) =>
  page.getByRole("dialog", { name: `Replace ${name}?` });

/** Opens the sheet of a button and asks to write under a name. */
async function write(page: Page, button: string, name: string): Promise<void> {
  await page.getByRole("button", { name: button }).click();
  await page.getByLabel("Name").fill(name);
  await page.getByRole("button", { name: "Write" }).click();
}

it("asks before a drawing replaces a file, with the mouse", async () => {
  put("door.rsg", old);
  const page = await drawn();
  await write(page, "Save…", "door.rsg");
  const asked = question(page, "door.rsg");
  await asked.waitFor();
  const text = await asked.textContent();
  for (const words of ["a drawing", `${old.length} B`, "changed today", "20 versions"])
    expect(text).toContain(words);
  await asked.getByRole("button", { name: "Cancel" }).click();
  await asked.waitFor({ state: "detached" });
  expect(read("door.rsg")).toBe(old);
  expect((await stateOf(workshop)).drawing?.changed).toBe(true);

  await page.getByRole("button", { name: "Write" }).click();
  await asked.getByRole("button", { name: "Replace" }).click();
  await until(async () => (await stateOf(workshop)).drawing?.changed === false, "it is saved");
  expect(read("door.rsg")).not.toBe(old);

  // Saved once more it is the same file: nobody is asked.
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 50,0 10" } });
  await until(async () => (await stateOf(workshop)).drawing?.changed === true, "it is changed");
  await write(page, "Save…", "door.rsg");
  await until(async () => (await stateOf(workshop)).drawing?.changed === false, "it is saved");
  expect(workshop.mistakes.filter((told) => !told.includes("409"))).toEqual([]);
});

it("asks before a part program replaces a file, with the keyboard", async () => {
  put("drawing.sbp", old);
  const page = await drawn();
  await tabTo(page, "Make the part program…");
  await page.keyboard.press("Enter");
  await page.getByLabel("Name").waitFor();
  await page.keyboard.press("Enter");
  const asked = question(page, "drawing.sbp");
  await asked.waitFor();
  expect(await asked.textContent()).toContain("a part program of 3 lines");
  // Enter alone replaces nothing, and Esc does not either.
  await page.keyboard.press("Enter");
  await asked.waitFor({ state: "detached" });
  expect(read("drawing.sbp")).toBe(old);
  await tabTo(page, "Write");
  await page.keyboard.press("Enter");
  await asked.waitFor();
  await page.keyboard.press("Escape");
  await asked.waitFor({ state: "detached" });
  expect(read("drawing.sbp")).toBe(old);
  await tabTo(page, "Write");
  await page.keyboard.press("Enter");
  await asked.waitFor();
  await tabTo(page, "Replace");
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).opened?.name === "drawing.sbp", "it is open");
  expect(read("drawing.sbp")).not.toBe(old);
});
