/** STOP from wherever a person may be, in whatever the machine is doing: a walk by dice. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import {
  act,
  arm,
  hold,
  keysOf,
  moment,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

const long = "SA\nMS,1,1\nM3,20,10,1\nM3,0,0,0\nM3,20,10,1\nM3,0,0,0\nEND\n";

beforeAll(async () => {
  workshop = await openWorkshop();
  writeFileSync(join(workshop.parts, "long.sbp"), long);
  writeFileSync(join(workshop.parts, "ask.sbp"), "MSGBOX(Go on?, YesNo)\nMX,20\nEND\n");
  writeFileSync(join(workshop.parts, "edit.sbp"), "FE,ask.sbp\nMX,20\nEND\n");
  page = await workshop.page();
  await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "complex"));
  await page.reload();
  await page.getByLabel("Command line").waitFor();
});
afterAll(() => workshop?.close());

/** Numbers that look like chance and are the same every time. */
function dice(seed: number): (sides: number) => number {
  let state = seed;
  return (sides) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * sides);
  };
}

/** The page is there, drives, and the machine is armed. */
async function drives(): Promise<void> {
  await script(workshop, "stop");
  await page.goto(workshop.address);
  await page.getByLabel("Command line").waitFor();
  // The page that was here before drove: when it is seen to have gone, the machine is disarmed.
  await until(
    async () => (await stateOf(workshop)).clients.length === 1,
    "the page before is gone",
  );
  await page.locator(".state", { hasText: "Disarmed" }).waitFor();
  await arm(page);
}

async function opens(name: string): Promise<void> {
  await script(workshop, "open", { name });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, `${name} is previewed`);
  // Start runs what the page shows: what was there before would be refused.
  await page.locator(".job-name", { hasText: name }).waitFor();
}

const begins = (state: string) =>
  until(async () => (await stateOf(workshop)).machine.state === state, state);

async function starts(name: string): Promise<void> {
  await opens(name);
  await page.getByRole("button", { name: "Start" }).click();
}

/** Everything a machine can be doing that STOP ends. */
const doings: Record<string, () => Promise<void>> = {
  async running() {
    await starts("long.sbp");
    await begins("running");
    await until(async () => (await stateOf(workshop)).motion.speedMmS > 1, "it moves");
  },
  async held() {
    await doings.running?.();
    await page.getByRole("button", { name: "Hold" }).click();
    await begins("held");
  },
  async stopped() {
    await doings.running?.();
    await script(workshop, "stop");
    await begins("stopped");
  },
  async asking() {
    await starts("ask.sbp");
    await begins("asking");
  },
  async step() {
    await opens("long.sbp");
    await act(page, "single step");
    await begins("asking");
  },
  async keypad() {
    await page.getByLabel("Command line").press("k");
    await begins("asking");
    await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  },
  async editing() {
    await starts("edit.sbp");
    await page.getByRole("region", { name: "The program waits" }).waitFor();
    await begins("asking");
  },
  async typed() {
    const line = page.getByLabel("Command line");
    await line.pressSequentially("mx20");
    await line.press("Enter");
    await begins("running");
  },
};

const route = (name: string) => () => page.getByRole("link", { name, exact: true }).click();
const key = (keys: string) => async () => {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press(keys);
};

/** An action of the palette. */
const chosen = (words: string) => async () => {
  await key("Control+k")();
  await page.getByRole("dialog", { name: "Every action" }).waitFor({ timeout: 5000 });
  await page.keyboard.type(words);
  await page.getByRole("option").first().waitFor({ timeout: 5000 });
  await page.keyboard.press("Enter");
};

/** Everywhere a person may be meanwhile. */
const places: Record<string, () => Promise<void>> = {
  operate: route("Operate"),
  edit: route("Edit"),
  draw: route("Draw"),
  settings: route("Settings"),
  help: route("Help"),
  files: key("Control+o"),
  palette: key("Control+k"),
  keypad: key("k"),
  "scratch pad": key("i"),
  calculator: key("F10"),
  recorder: chosen("Recorded commands"),
  "virtual tools": chosen("Virtual tools"),
  inputs: chosen("Inputs of the machine"),
  confirmation: chosen("Recover job"),
  "large picture": () => page.getByRole("button", { name: "Large" }).click({ timeout: 5000 }),
  values: key("Control+Shift+V"),
  nudge: key("Control+Shift+N"),
  async sheet() {
    await route("Settings")();
    await page.getByRole("button", { name: "VS", exact: true }).click();
  },
};

/** The ways in which a hand presses it. */
const presses: Record<string, () => Promise<void>> = {
  mouse: () => page.getByRole("button", { name: "STOP", exact: true }).click(),
  enter: () => page.getByRole("button", { name: "STOP", exact: true }).press("Enter"),
  async finger() {
    const stop = page.getByRole("button", { name: "STOP", exact: true });
    await stop.dispatchEvent("pointerdown", { pointerType: "touch", isPrimary: true });
  },
};

/** Nothing is under way: it stands and waits, or asks whether to go on. */
const overStates = ["idle", "stopped"];

/** Goes somewhere, unless a question is in the way: that is a place, too. */
async function goes(where: () => Promise<void>): Promise<void> {
  const covered = (await page.locator("main.screen[inert]").count()) > 0;
  const links = await page.getByRole("link", { name: "Edit", exact: true }).isVisible();
  if (!covered || links) await where().catch(() => undefined);
}

const pick = <T>(roll: (sides: number) => number, of: Record<string, T>): [string, T] => {
  const all = Object.entries(of);
  const chosen = all[roll(all.length)];
  if (!chosen) throw new Error("there is nothing to choose from");
  return chosen;
};

const steps = 30;

/** STOP lies where it lay, enabled, and nothing is over it. */
async function stopIsThere(place: Place | null, step: string): Promise<void> {
  const stop = page.getByRole("button", { name: "STOP", exact: true });
  expect(await stop.boundingBox(), step).toEqual(place);
  expect(await stop.isEnabled(), step).toBe(true);
  const middle = { x: (place?.x ?? 0) + 20, y: (place?.y ?? 0) + 20 };
  const over = ({ x, y }: typeof middle) => document.elementFromPoint(x, y)?.textContent;
  expect(await page.evaluate(over, middle), `${step}: nothing covers it`).toBe("STOP");
}

type Place = { x: number; y: number; width: number; height: number };

/** Presses and waits until the machine stands; how long that took. */
async function stopped(press: () => Promise<void>, step: string): Promise<number> {
  const before = (await stateOf(workshop)).machine.state;
  const at = performance.now();
  await press();
  await until(async () => {
    const { machine, motion } = await stateOf(workshop);
    const ended = before !== "stopped" || machine.state === "idle";
    return ended && overStates.includes(machine.state) && motion.speedMmS === 0;
  }, `${step}: it stands`);
  const tookMs = performance.now() - at;
  // Nothing but the file's own end is "ok": it was long enough to be stopped before.
  const { job } = await stateOf(workshop);
  if (job?.file.endsWith("long.sbp")) expect(job.ended, step).not.toBe("ok");
  return tookMs;
}

it("sbp_con_stop__from_everywhere: stops whatever the machine does, wherever the person is", async () => {
  const roll = dice(20261122);
  await drives();
  const place = await page.getByRole("button", { name: "STOP", exact: true }).boundingBox();
  const walked = new Set<string>();
  let longestMs = 0;
  for (let n = 0; n < steps; n += 1) {
    const [doing, begin] = Object.entries(doings)[n] ?? pick(roll, doings);
    const [where, go] = Object.entries(places)[n] ?? pick(roll, places);
    const [how, press] = Object.entries(presses)[n] ?? pick(roll, presses);
    const step = `${n}: ${doing}, ${where}, ${how}`;
    await drives();
    await begin();
    await goes(go);
    await stopIsThere(place, step);
    longestMs = Math.max(longestMs, await stopped(press, step));
    walked.add(`${doing} ${where}`);
    // A second press gives up what stands.
    await script(workshop, "stop");
    await begins("idle");
  }
  const figures = `${walked.size} different; the longest took ${Math.round(longestMs)} ms`;
  console.log(`${steps} stops, ${figures}`);
}, 1_200_000);

it("stops while the tool is moved by the keypad, by the space bar and by the button", async () => {
  for (const press of [() => page.keyboard.press("Space"), presses.mouse]) {
    await drives();
    await page.getByLabel("Command line").press("k");
    await page.getByRole("dialog", { name: "Keypad" }).waitFor();
    const { motion: before } = await stateOf(workshop);
    const hand = keysOf(page, ["ArrowRight"]);
    const goes = ({ motion }: Snapshot) => motion.at.working[0] > before.at.working[0] + 1;
    await hold(workshop, hand, goes, "it moves");
    await press?.();
    await begins("idle");
    const { motion } = await stateOf(workshop);
    await moment(400);
    expect((await stateOf(workshop)).motion.at).toEqual(motion.at);
    await hand.up();
  }
});
