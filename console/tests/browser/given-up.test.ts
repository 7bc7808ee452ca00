/** A wait is told, and what is waited for can be given up. */

import { existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, beforeEach, expect, it } from "vitest";
import { circles } from "./shapes";
import { openWorkshop, stateOf, tabTo, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeEach(async () => {
  workshop = await openWorkshop({ rate: 100 });
});
afterEach(() => workshop?.close());

it("gives up a drawing that is being read, with the mouse", async () => {
  // It takes seconds to be read, even where nothing else runs.
  writeFileSync(join(workshop.parts, "heavy.dxf"), circles(1_500_000));
  const page = await workshop.page();
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByLabel("Name").fill("heavy.dxf");
  await page.getByRole("button", { name: "Open", exact: true }).click();
  await page.getByText("heavy.dxf is being read.").waitFor();
  await page.getByRole("button", { name: "Give up" }).click();
  await page
    .getByText(/it was given up/)
    .first()
    .waitFor();
  expect(await page.getByText("heavy.dxf is being read.").count()).toBe(0);
  expect((await stateOf(workshop)).drawing?.name ?? null).toBeNull();
});

it("gives up a tool path that is being made, with the keyboard", async () => {
  writeFileSync(join(workshop.parts, "heavy.dxf"), circles(200_000));
  const page = await workshop.page();
  const headers = { ...workshop.shows, "content-type": "application/json" };
  const body = JSON.stringify({ name: "heavy.dxf" });
  await fetch(`${workshop.address}/api/do/open`, { method: "POST", headers, body });
  await until(async () => (await stateOf(workshop)).opened?.name === "heavy.dxf", "it is open");
  await page.getByRole("link", { name: "Operate" }).click();
  await tabTo(page, /^Make the tool path/);
  await page.keyboard.press("Enter");
  await page.getByText("The tool path is being made.").waitFor();
  await tabTo(page, "Give up");
  await page.keyboard.press("Enter");
  await page.getByText("The tool path is being made.").waitFor({ state: "detached" });
  await page
    .getByText(/given up/)
    .first()
    .waitFor();
  expect(existsSync(join(workshop.parts, "heavy.rsm"))).toBe(false);
});
