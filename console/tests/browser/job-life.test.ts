/** A job and the people around it: two browsers, reloads, keys only, a move in between, the emergency stop. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect, it } from "vitest";
import {
  act,
  arm,
  comesToRest,
  enter,
  hold,
  keysOf,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let pages: Page[] = [];

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 2 });
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  file("cut.sbp", "SA\nMS,1,1\nM2,6,0\nM2,6,3\nM2,0,0\nEND\n");
  file("ask.sbp", "MSGBOX(Is it clamped?, YesNo)\nM2,0.5,0\nEND\n");
});
afterAll(() => workshop?.close());
afterEach(async () => {
  await comesToRest(workshop);
  for (const page of pages) await page.close();
  pages = [];
  await until(async () => (await stateOf(workshop)).lease === null, "nobody drives");
});

const begins = (state: string) =>
  until(async () => (await stateOf(workshop)).machine.state === state, state);

async function comes(): Promise<Page> {
  const page = await workshop.page();
  pages.push(page);
  await page.locator(".location-number").first().waitFor();
  return page;
}

async function previewed(name: string): Promise<void> {
  await script(workshop, "open", { name });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, `${name} is previewed`);
}

async function cuts(page: Page): Promise<void> {
  await previewed("cut.sbp");
  await page.getByRole("button", { name: "Start" }).click();
  await until(async () => (await stateOf(workshop)).motion.speedMmS > 5, "it cuts");
}

const word = (page: Page) => page.locator(".state strong").textContent();

it("after a stop the tool is moved away, and the cut goes on where it was", async () => {
  const page = await comes();
  await arm(page);
  await cuts(page);
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  await begins("stopped");
  const stood = (await stateOf(workshop)).motion.at.working;
  await page.getByRole("button", { name: "Move the tool…" }).click();
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  const hand = keysOf(page, ["ArrowUp"]);
  await hold(workshop, hand, (now) => now.motion.at.working[1] > stood[1] + 2, "it is moved");
  await hand.up();
  await begins("stopped");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Resume" }).last().click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the job is done");
  expect((await stateOf(workshop)).motion.at.working.slice(0, 2)).toEqual([0, 0]);
});

it("two browsers: one drives, both stop, whoever takes over finds it disarmed", async () => {
  const [one, two] = [await comes(), await comes()];
  await arm(one);
  await two.getByText(/Driven by/).waitFor();
  await cuts(one);
  await two.locator(".state", { hasText: "Running" }).waitFor();
  await two.getByRole("button", { name: "STOP", exact: true }).click();
  await one.getByRole("button", { name: "Quit" }).waitFor();
  await one.getByRole("button", { name: "Quit" }).click();
  await begins("idle");
  await two.getByRole("button", { name: "Take control" }).click();
  await two.locator(".state", { hasText: "Disarmed" }).waitFor();
  await one.getByText(/Driven by/).waitFor();
  expect((await stateOf(workshop)).machine.armed).toBe(false);
});

it("a page that is loaded again shows what the machine does, in each of its states", async () => {
  const page = await comes();
  const same = async (shows: () => Promise<void>) => {
    await shows();
    const before = await word(page);
    await page.reload();
    await page.locator(".location-number").first().waitFor();
    await shows();
    expect(await word(page)).toBe(before);
  };
  const state = (text: string) => () => page.locator(".state", { hasText: text }).waitFor();
  await same(state("Disarmed"));
  await arm(page);
  await cuts(page);
  await same(state("Running"));
  await page.getByRole("button", { name: "Hold" }).click();
  await same(state("Held"));
  // The page that drove was gone for a moment: somebody has to say that all is clear.
  await page.getByRole("button", { name: "Arm", exact: true }).click();
  await page.getByRole("button", { name: "Resume" }).click();
  await begins("running");
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  await same(async () => {
    await page.getByRole("button", { name: "Quit" }).waitFor();
  });
  await page.getByRole("button", { name: "Quit" }).click();
  await begins("idle");
  await previewed("ask.sbp");
  await page.getByRole("button", { name: "Start" }).click();
  await same(async () => {
    await page.locator(".question-text", { hasText: "Is it clamped?" }).waitFor();
  });
}, 120_000);

it("a job is opened, started and answered with keys only", async () => {
  const page = await comes();
  await page.keyboard.press("Control+o");
  await page.getByRole("dialog", { name: "Part folder" }).waitFor();
  // By its whole name: the log of an earlier run lies beside it.
  await page.keyboard.type("ask.sbp");
  await expect.poll(() => page.getByRole("option").count()).toBe(1);
  await enter(page, /ask\.sbp/);
  await page.getByRole("dialog").waitFor({ state: "detached" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  const action = async (words: string) => {
    await act(page, words);
    await page.getByRole("dialog", { name: "Every action" }).waitFor({ state: "detached" });
  };
  await action("Arm the machine");
  // The page has to know it too: it arms a machine that it takes for disarmed.
  await page.locator(".state", { hasText: "Ready" }).waitFor();
  await action("Start");
  await page.locator(".question-text", { hasText: "Is it clamped?" }).waitFor();
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the job is done");
  expect((await stateOf(workshop)).opened?.name).toBe("ask.sbp");
});

it("an emergency stop of the machine ends the job, and the page says so", async () => {
  const page = await comes();
  await arm(page);
  const { lease } = await stateOf(workshop);
  expect(lease).not.toBeNull();
  await page.getByRole("link", { name: "Settings" }).click();
  await page.getByLabel("Search settings").fill("io.inputs");
  const field = page.getByLabel("Inputs, 5", { exact: true });
  await field.fill("3");
  await field.press("Enter");
  await until(async () => (await stateOf(workshop)).io.inputs[4]?.duty === "stop", "input 5 stops");
  await page.getByRole("link", { name: "Operate" }).click();
  await cuts(page);
  await page.getByRole("button", { name: "In", exact: true }).click();
  await page.getByRole("switch", { name: "Input 5" }).click();
  await until(async () => (await stateOf(workshop)).machine.state !== "running", "it stands");
  await until(async () => (await stateOf(workshop)).motion.speedMmS === 0, "nothing moves");
  expect(await word(page)).not.toBe("Running");
  // The switch is let go from the question that stands over everything.
  await page.getByRole("button", { name: "Inputs…" }).click();
  await page.getByRole("switch", { name: "Input 5" }).last().click();
  await until(async () => (await stateOf(workshop)).io.inputs[4]?.on === false, "it is let go");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Quit" }).click();
  await until(async () => (await stateOf(workshop)).machine.state !== "stopped", "the job is over");
});
