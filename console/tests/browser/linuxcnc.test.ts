import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import { LinuxCnc } from "./controller";
import {
  act,
  arm,
  hold,
  keysOf,
  openWorkshop,
  stands,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let linuxcnc: LinuxCnc;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  linuxcnc = new LinuxCnc("unhomed");
  workshop = await openWorkshop({ controller: `linuxcnc:${await linuxcnc.port()}` });
  writeFileSync(
    join(workshop.parts, "square.sbp"),
    ["SO,1,1", "MS,1", "MX,3", "MY,2", "MX,0", "MY,0", "SO,1,0", ""].join("\n"),
  );
  page = await workshop.page();
});
afterAll(async () => {
  await workshop?.close();
  linuxcnc?.unplug();
});

/** The page and LinuxCNC say the same place. */
async function agree(): Promise<number[]> {
  await until(() => stands(workshop), "it stands");
  const { place } = await linuxcnc.look();
  const told = (await stateOf(workshop)).motion.at.machine;
  for (const [axis, mm] of place.entries()) expect(told[axis], `axis ${axis}`).toBeCloseTo(mm, 2);
  return place;
}

const state = (word: string) => page.locator(".state", { hasText: word });

async function starts(): Promise<void> {
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK" }).click();
  await state("Running").waitFor();
}

it("names LinuxCNC, and homes it", async () => {
  const chip = page.locator(".mode");
  expect(await chip.textContent()).toContain("CUT");
  expect(await chip.getAttribute("title")).toContain("linuxcnc:127.0.0.1");
  expect(await violations(page)).toEqual([]);
  await arm(page);
  await act(page, "Find the machine's home");
  await page.getByText("the controller has homed its axes").waitFor();
  await until(async () => (await stateOf(workshop)).setup.notHomed === "", "all is homed");
  await agree();
});

it("jogs for as long as a key is held", async () => {
  const [before = 0] = await agree();
  await page.getByRole("button", { name: "Move tool" }).click();
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  const hand = keysOf(page, ["ArrowRight"]);
  const goes = ({ motion }: Snapshot) => (motion.at.machine[0] ?? 0) - before > 5;
  await hold(workshop, hand, goes, "it moves");
  await hand.up();
  const [there = 0] = await agree();
  expect(there - before).toBeGreaterThan(5);
  await new Promise((resolve) => setTimeout(resolve, 500));
  expect((await linuxcnc.look()).place[0], "nothing moves any more").toBe(there);
  await page.keyboard.press("Escape");
});

it("runs a file, holds it and goes on, also at its own panel, to its end", async () => {
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: "square.sbp" }).click();
  await page.keyboard.press("Enter");
  await starts();
  await until(async () => (await stateOf(workshop)).motion.speedMmS > 10, "it moves");
  await page.getByRole("button", { name: "Hold" }).click();
  await state("Held").waitFor();
  const stood = await agree();
  expect(await agree(), "it stands").toEqual(stood);
  await page.getByRole("button", { name: "Resume" }).click();
  await state("Running").waitFor();
  linuxcnc.work("pause");
  await page.getByText("it is held at its own panel").first().waitFor();
  linuxcnc.work("resume");
  await page.getByText("finished").waitFor();
  const [endX = 0, endY = 0] = await agree();
  expect([endX, endY]).toEqual([0, 0]);
  expect((await linuxcnc.look()).rpm).toBe(null);
});

it("stops where LinuxCNC stands, with the spindle off", async () => {
  await starts();
  await until(async () => (await stateOf(workshop)).motion.speedMmS > 10, "it moves");
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  const quit = page.getByRole("button", { name: "Quit" });
  await quit.waitFor();
  await agree();
  expect((await linuxcnc.look()).rpm).toBe(null);
  await quit.click();
  await state("Ready").waitFor();
  await agree();
});

it("tells that its emergency stop is pressed while it stands, and when it is released", async () => {
  linuxcnc.work("estop");
  const told = page.locator(".state", { hasText: "its emergency stop is pressed" });
  await told.waitFor();
  await state("Disarmed").waitFor();
  linuxcnc.work("on");
  await told.waitFor({ state: "detached" });
  await arm(page);
});

it("shows its zero points, changes them, and sees one that is set at its panel", async () => {
  const row = (name: string) =>
    page.getByRole("row").filter({ hasText: new RegExp(`^${name}[^.]`) });
  await act(page, "Zero points of the controller");
  await page.getByRole("dialog", { name: "Zero points of the controller" }).waitFor();
  expect(await page.locator(".zeros tbody tr").count()).toBe(11);
  const form = page.getByRole("region", { name: "Set a zero point" });
  await form.getByLabel("Zero point").selectOption("G55");
  await form.getByRole("radio", { name: "It lies at, from home" }).click();
  await form.getByLabel("X", { exact: true }).fill("2");
  await form.getByRole("button", { name: "Set G55" }).click();
  await until(async () => (await stateOf(workshop)).zeros[1]?.at[0] === 50.8, "it is written");
  await page.getByRole("button", { name: "Use G55" }).click();
  await until(async () => (await stateOf(workshop)).zeros[1]?.holds === true, "it holds");
  linuxcnc.work("panel G10L2P2X76.2");
  await row("G55").getByText("3.000").waitFor();
  await page.keyboard.press("Escape");
  const others = workshop.mistakes.filter((told) => !/404 .*\/api\/preview\//.test(told));
  expect(others).toEqual([]);
});
