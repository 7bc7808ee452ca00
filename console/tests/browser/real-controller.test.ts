import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import {
  act,
  arm,
  hold,
  keysOf,
  stands,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

const square = ["SO,1,1", "MS,2", "MX,2", "MY,2", "MX,0", "MY,0", "SO,1,0", ""].join("\n");

beforeAll(async () => {
  const waits = "'Close the clamp\nPAUSE UNTIL 1,1\nSR\nMX,1\nSA\n";
  const driven = await driveController({ "square.sbp": square, "until.sbp": waits }, "22=1");
  ({ controller, workshop, page } = driven);
  return driven.close;
});

const working = async () => (await stateOf(workshop)).motion.at.machine;

/** The page and the controller say the same place. */
async function agree(): Promise<number[]> {
  await until(() => stands(workshop), "it stands");
  const { place } = await controller.look();
  const told = await working();
  for (const [axis, mm] of place.entries()) expect(told[axis], `axis ${axis}`).toBeCloseTo(mm, 2);
  return place;
}

it("says which machine it drives", async () => {
  const chip = page.locator(".mode");
  expect(await chip.textContent()).toContain("CUT");
  expect(await chip.getAttribute("title")).toContain("grbl:/");
  const filled = await chip.evaluate((at) => getComputedStyle(at).backgroundColor);
  expect(filled, "its word is of the colour of the panel").not.toBe("rgba(0, 0, 0, 0)");
  expect(await violations(page)).toEqual([]);
});

it("homes a controller that was locked until it is homed", async () => {
  await arm(page);
  await act(page, "Find the machine's home");
  await page.getByText("the controller has homed its axes").waitFor();
  await until(
    async () => (await stateOf(workshop)).setup.notHomed === "",
    "nothing is left to home",
  );
  await agree();
});

it("does not offer its switches and its card, in preview either", async () => {
  const chip = page.locator(".mode");
  const offered = () =>
    page.getByRole("button", { name: "In", exact: true, includeHidden: true }).count();
  expect(await offered()).toBe(0);
  await chip.click();
  await expect.poll(() => chip.textContent()).toContain("PREVIEW");
  expect(await offered()).toBe(0);
  expect((await stateOf(workshop)).machine.offers).toEqual({
    inputs: false,
    card: false,
    startArms: false,
  });
  await chip.click();
  await expect.poll(() => chip.textContent()).toContain("CUT");
});

it("moves for as long as a key is held", async () => {
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
  expect((await controller.look()).place[0], "nothing moves any more").toBe(there);
  await page.keyboard.press("Escape");
});

it("runs a file, faster and slower, holds it and goes on, to its end", async () => {
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: "square.sbp" }).click();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK" }).click();
  await page.locator(".state", { hasText: "Running" }).waitFor();
  await page.getByRole("button", { name: "Hold" }).click();
  await page.locator(".state", { hasText: "Held" }).waitFor();
  const stood = await agree();
  expect(await agree(), "it stands").toEqual(stood);
  await page.getByRole("button", { name: "Resume" }).click();
  await page.locator(".state", { hasText: "Running" }).waitFor();
  const feed = page.getByRole("slider", { name: "Feed" });
  await feed.focus();
  await page.keyboard.press("Home");
  await until(async () => {
    const { overrides, motion } = await stateOf(workshop);
    // A tenth of 2 in/s.
    return overrides.feedPercent === 10 && motion.speedMmS > 0 && motion.speedMmS < 5.1;
  }, "the feed is turned");
  const full = (await controller.look()).rpm ?? 0;
  expect(full).toBeGreaterThan(0);
  await page.getByLabel("Spindle", { exact: true }).selectOption("80 %");
  await until(async () => (await controller.look()).rpm === 0.8 * full, "the spindle is turned");
  await page.getByLabel("Rapids", { exact: true }).selectOption("25 %");
  await until(async () => (await stateOf(workshop)).overrides.rapidPercent === 25, "rapids, too");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/overrides.png` });
  await page.getByRole("button", { name: "100 %" }).click();
  await page.getByText("finished").waitFor();
  const [endX = 0, endY = 0] = await agree();
  expect([endX, endY]).toEqual([0, 0]);
  expect((await controller.look()).rpm).toBe(null);
});

it("stops in the middle where the controller stands, with the spindle off", async () => {
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK" }).click();
  await page.locator(".state", { hasText: "Running" }).waitFor();
  await until(async () => (await stateOf(workshop)).motion.speedMmS > 10, "it moves");
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  const quit = page.getByRole("button", { name: "Quit" });
  await quit.waitFor();
  await agree();
  expect((await controller.look()).rpm).toBe(null);
  await quit.click();
  await page.locator(".state", { hasText: "Ready" }).waitFor();
  await agree();
});

it("goes on when an input of the controller comes for which a program waits", async () => {
  const [before = 0] = await agree();
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name: "until.sbp" }).click();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Start" }).click();
  await page.locator(".question-text", { hasText: "Close the clamp" }).waitFor();
  controller.work("pins P");
  // Nobody presses anything in the question.
  await page.getByText("finished").waitFor();
  const [there = 0] = await agree();
  expect(there - before).toBeCloseTo(25.4, 2);
  controller.work("pins");
});

it("tells an alarm when the controller is gone", async () => {
  controller.unplug();
  await page.locator(".state", { hasText: "Alarm" }).waitFor();
  // A preview that was asked for is gone where the machine was moved meanwhile: it is made anew.
  const others = workshop.mistakes.filter((told) => !/404 .*\/api\/preview\//.test(told));
  expect(others).toEqual([]);
});
