import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, openWorkshop, stands, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const folder = mkdtempSync(join(tmpdir(), "kerf-console-"));
  writeFileSync(
    join(folder, "change.sbp"),
    "SO,1,1\nMZ,-.1\nMX,.2\n'Change the tool\nPAUSE\nMX,.4\nSO,1,0\nEND\n",
  );
  workshop = await openWorkshop({ folder, open: "change.sbp", rate: 20 });
  page = await workshop.page();
});
afterAll(() => workshop?.close());

const z = async () => (await stateOf(workshop)).motion.at.working[2] / 25.4;
const spindle = async () => (await stateOf(workshop)).io.outputs[0]?.on;

it("a pause with the tool in the cut lifts it, and goes on where it was", async () => {
  await arm(page);
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK" }).click();
  const question = page.getByRole("dialog").filter({ hasText: "Change the tool" });
  await question.waitFor();
  expect(await z()).toBeCloseTo(-0.1);
  expect(await spindle()).toBe(true);
  await question.getByRole("button", { name: "Lift the tool" }).click();
  await until(async () => (await z()) > 0.9, "the tool is up");
  expect(await spindle()).toBe(false);
  await question.getByRole("button", { name: "OK" }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the file is over");
  await until(() => stands(workshop), "it stands");
  const { motion } = await stateOf(workshop);
  expect(motion.at.working[0] / 25.4).toBeCloseTo(0.4);
  expect(motion.at.working[2] / 25.4).toBeCloseTo(-0.1);
});
