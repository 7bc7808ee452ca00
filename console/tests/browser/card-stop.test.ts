/** The emergency stop of the card, practised at the page: pressed and released while a job runs; and what the page says of it. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { lengthText, placeText } from "../../src/app/units";
import { mm } from "../../src/units/quantity";
import {
  act,
  arm,
  openWorkshop,
  script,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 8 });
  const draw = (op: object) => script(workshop, "draw", { op });
  await draw({ op: "new" });
  await draw({ op: "do", clauses: "line 0,40 900,40; line 0,80 900,80" });
  await draw({ op: "save", name: "two.rsg" });
  page = await workshop.page({ width: 1360, height: 800 });
  await script(workshop, "machine", { drawing: "two.rsg" });
  await page.getByRole("link", { name: "Operate" }).click();
  await page.locator(".job-head", { hasText: "two.rsm" }).waitFor();
});
afterAll(() => workshop?.close());

const strip = () => page.locator(".state");
const paused = (why: string) => page.getByRole("dialog", { name: why, exact: true });
const previewed = () =>
  until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");

/** Moves a switch of the topmost sheet of inputs with the mouse, and sees it moved. Its list comes a moment after it. */
async function press(number: number, on: boolean): Promise<void> {
  const one = inputs()
    .last()
    .getByRole("switch", { name: `Input ${number}`, exact: true });
  await expect.poll(() => one.getAttribute("aria-checked")).toBe(String(!on));
  await one.click();
  await expect.poll(() => one.getAttribute("aria-checked")).toBe(String(on));
}

const inputs = () => page.getByRole("dialog", { name: "Inputs of the machine" });

async function openInputs(): Promise<void> {
  await act(page, "Inputs of the");
  await inputs().waitFor();
}

const doubleStart = async (on: "yes" | "no") => {
  await page.getByRole("link", { name: "Settings" }).click();
  await page.getByLabel("Search settings").fill("double_start");
  await page.getByRole("radio", { name: on }).click();
  await page.getByRole("link", { name: "Operate" }).click();
};

// The head stands where it was when the machine was switched on.
it("pro_misc_doublestart: the sheet says where the head is, and Start goes from there to the path", async () => {
  await arm(page);
  await doubleStart("yes");
  await previewed();
  const head = (await stateOf(workshop)).motion.at.machine;
  const [startX = 0, startY = 0] = (await (await fetch(`${workshop.address}/api/job`)).json())
    .paths[0].points;
  const awayMm = Math.hypot(head[0] - startX, head[1] - startY);
  expect(awayMm).toBeGreaterThan(10);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  const dialog = page.getByRole("dialog", { name: "Start with shape 1?" });
  await dialog.waitFor();
  const words = (await dialog.locator(".paused > p").first().textContent()) ?? "";
  const { units } = await stateOf(workshop);
  expect(words).toContain(`The head stands at ${placeText([head[0], head[1]], units)}`);
  expect(words).toContain(`${lengthText(mm(awayMm), units)} from the beginning of path 1`);
  expect(words).not.toContain("stands over the beginning");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/double-start.png` });
  await dialog.getByRole("button", { name: "Start", exact: true }).click();
  let line = 0;
  await until(async () => {
    const { motion } = await stateOf(workshop);
    line = motion.line;
    return motion.cutting;
  }, "it cuts");
  expect(line).toBe(1);
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the job is done");
  await doubleStart("no");
});

it("with the emergency stop active the page does not say Ready, and says how to mend it", async () => {
  await openInputs();
  await press(19, true);
  await strip().filter({ hasText: "Stop pressed" }).waitFor();
  expect(await strip().textContent()).toContain("release the emergency stop");
  expect(await strip().textContent()).not.toContain("Ready");
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/stop-pressed.png` });
  await press(19, false);
  await strip().filter({ hasText: "Ready" }).waitFor();
  await page.keyboard.press("Escape");
});

it("pro_estop_operator: pressed in a job, released, acknowledged, gone on with: all by mouse", async () => {
  await previewed();
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => (await stateOf(workshop)).motion.cutting, "it cuts");
  await openInputs();
  await press(19, true);
  const stopped = paused("Paused: emergency stop");
  await until(
    async () => (await stateOf(workshop)).asked?.text === "Paused: emergency stop",
    "paused",
  );
  await strip().filter({ hasText: "Stop pressed" }).waitFor();
  await stopped.waitFor();
  await stopped.getByText("Nothing moves: release the emergency stop.").waitFor();
  const [x] = (await stateOf(workshop)).motion.at.machine;
  // Resume says what is missing, and does nothing else.
  const before = (await stateOf(workshop)).asked?.number;
  await stopped.getByRole("button", { name: "Resume" }).click();
  await until(async () => {
    const { asked } = await stateOf(workshop);
    return asked?.text === "Paused: emergency stop" && asked.number !== before;
  }, "asked again");
  expect((await stateOf(workshop)).motion.at.machine[0]).toBe(x);
  expect((await stateOf(workshop)).io.ports.inputs[0] & 0x40).toBe(0x40);
  await stopped.getByRole("button", { name: "Inputs…" }).click();
  // Over the one that lay open before.
  await expect.poll(() => inputs().count()).toBe(2);
  await press(19, false);
  expect((await stateOf(workshop)).io.ports.inputs[0] & 0x40).toBe(0);
  // The other lines of the card too, during the pause: on and off.
  for (const number of [17, 21]) for (const on of [true, false]) await press(number, on);
  await inputs().last().getByRole("button", { name: "Close" }).click();
  await expect.poll(() => stopped.getByText("Nothing moves").count()).toBe(0);
  await strip().filter({ hasText: "Paused" }).waitFor();
  expect(await violations(page)).toEqual([]);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/paused.png` });
  // Acknowledged, then gone on with.
  await stopped.getByRole("button", { name: "Resume" }).click();
  const released = paused("Paused: emergency stop released");
  await released.getByRole("button", { name: "Resume" }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the job is done");
  // The sheet that lay open before the pause.
  await page.keyboard.press("Escape");
  await inputs().waitFor({ state: "detached" });
});

it("a pause is headed Paused, not Stopped in red", async () => {
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => (await stateOf(workshop)).motion.cutting, "it cuts");
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  const dialog = paused("Paused");
  await dialog.waitFor();
  await strip().filter({ hasText: "Paused" }).waitFor();
  expect(await strip().textContent()).not.toContain("Stopped");
  const red = await page.evaluate(() => {
    const [dot, stop] = [document.querySelector(".state-dot"), document.documentElement];
    const probe = document.createElement("i");
    probe.style.background = "var(--stop)";
    stop.append(probe);
    const colours = [dot, probe].map((one) => one && getComputedStyle(one).backgroundColor);
    probe.remove();
    return colours[0] === colours[1];
  });
  expect(red).toBe(false);
  await dialog.getByRole("button", { name: "Quit" }).click();
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "given up");
});
