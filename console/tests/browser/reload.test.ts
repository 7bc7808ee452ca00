/** A page that is loaded again, and a second browser, see what the machine is doing. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import {
  arm,
  carryOut,
  comesToRest,
  command,
  commandDesk,
  hold,
  keysOf,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;
let other: Page;

const long = "SA\nMS,1,1\nM2,60,0\nEND\n";

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 2 });
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  file("long.sbp", long);
  file("steps.sbp", "SA\n&depth = 1\nMX,0.1\n&depth = 2\nMX,0.2\nEND\n");
  file("hand.sbp", "SK,Move it to the corner\nEND\n");
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  [page, other] = [await comes(), await comes()];
  await arm(page);
});
afterEach(async () => {
  await comesToRest(workshop);
  await page.close();
  await other.close();
  await until(async () => (await stateOf(workshop)).lease === null, "nobody drives");
});

const comes = () => commandDesk(workshop);

const now = async () => (await stateOf(workshop)).machine.state;
const begins = (state: string) => until(async () => (await now()) === state, state);

/** Both pages show it, before and after they are loaded again. */
async function everywhere(shows: (one: Page) => Promise<void>): Promise<void> {
  for (const one of [page, other]) await shows(one);
  for (const one of [page, other]) {
    await one.reload();
    await shows(one);
  }
}

/** A page that was loaded again drives and arms the machine while something is asked. */
async function armAnew(one: Page) {
  await one.getByRole("button", { name: "Arm", exact: true }).click();
  await until(async () => (await stateOf(workshop)).machine.armed, "it is armed");
}

const word = (text: string) => (one: Page) => one.locator(".state", { hasText: text }).waitFor();

it("an alarm is shown with its reason until somebody takes note of it", async () => {
  await carryOut(workshop, page, "VL,0,10,0,10,,,,,1");
  await command(page, "MX,30");
  await page.getByRole("button", { name: "End" }).click();
  await begins("alarm");
  await everywhere(async (one) => {
    await word("Alarm")(one);
    await one.getByRole("button", { name: "Acknowledge" }).waitFor();
    expect(await one.locator(".state").textContent()).toContain("limit");
  });
  await other.getByRole("button", { name: "Acknowledge" }).click();
  await begins("idle");
  await arm(page);
  await carryOut(workshop, page, "VL,,,,,,,,,0");
});

it("line by line: the line that is due, and what is watched, are the same everywhere", async () => {
  await page.getByRole("link", { name: "Edit" }).click();
  await page.getByRole("textbox", { name: "Variable" }).fill("&depth");
  await page.getByRole("button", { name: "Watch", exact: true }).click();
  await page.getByRole("link", { name: "Operate" }).click();
  await command(page, "FG,steps.sbp");
  const step = (one: Page) => one.getByRole("region", { name: "Line by line" });
  const due = (line: number) => async (one: Page) => {
    await step(one).getByText(`Line ${line}`, { exact: true }).waitFor();
  };
  await everywhere(due(1));
  // Whoever drove was loaded again: the line that is due moves nothing before somebody arms the machine.
  await step(other).getByText("To go on, arm the machine.").waitFor();
  await armAnew(other);
  for (const line of [2, 3]) {
    await step(other).getByRole("button", { name: "Step", exact: true }).click();
    for (const one of [page, other]) await due(line)(one);
  }
  await everywhere(async (one) => {
    await due(3)(one);
    await one.getByRole("link", { name: "Edit" }).click();
    await one.locator(".watched dd output", { hasText: "1" }).waitFor();
    await one.getByRole("link", { name: "Operate" }).click();
  });
});

it("the keypad of a part file, with what it says, is open everywhere; a jog is seen by the other", async () => {
  await command(page, "FP,hand.sbp");
  const keypad = (one: Page) => one.getByRole("dialog", { name: "Keypad" });
  const shows = (one: Page) => keypad(one).getByText("Move it to the corner").waitFor();
  for (const one of [page, other]) await shows(one);
  await keypad(other).getByText("Somebody else drives").waitFor();
  const stood = (await stateOf(workshop)).motion.at.working[0];
  const hand = keysOf(page, ["ArrowRight"]);
  const isSeen = () => other.locator(".state", { hasText: "Jogging" }).isVisible();
  const goes = async (here: Snapshot) => here.motion.at.working[0] > stood + 1 && (await isSeen());
  await hold(workshop, hand, goes, "it moves, and the other page sees it");
  // The page that holds the key is loaded again: nobody holds it any more.
  await page.reload();
  await begins("asking");
  const { motion } = await stateOf(workshop);
  expect(motion.at.working[0]).toBeGreaterThan(0);
  for (const one of [page, other]) await shows(one);
  await hand.up();
  await armAnew(page);
  await page.keyboard.press("Escape");
  await keypad(other).waitFor({ state: "detached" });
  await begins("idle");
});

it("sbp_lim_stop_key: a stop offers Resume, Quit, nudge and keypad on both pages, and a nudged job goes on shifted", async () => {
  await script(workshop, "open", { name: "long.sbp" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await page.getByRole("button", { name: "Start" }).click();
  await until(async () => (await stateOf(workshop)).motion.speedMmS > 5, "it cuts");
  await other.getByRole("button", { name: "STOP", exact: true }).click();
  await begins("stopped");
  await everywhere(async (one) => {
    const stopped = one.getByRole("dialog", { name: "Stopped" });
    for (const name of ["Resume", "Quit", "Nudge…", "Move the tool…"]) {
      await stopped.getByRole("button", { name, exact: true }).waitFor();
    }
  });
  await page
    .getByRole("dialog", { name: "Stopped" })
    .getByText("To go on, arm the machine.")
    .waitFor();
  await armAnew(page);
  const before = (await stateOf(workshop)).motion.at;
  await page.getByRole("button", { name: "Nudge…" }).click();
  const sheet = page.getByRole("dialog", { name: "Nudge" });
  await sheet.getByLabel("Distance").fill("0.1");
  await sheet.getByRole("button", { name: "Y +" }).click();
  await until(async () => (await now()) === "stopped", "it asks again");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Resume" }).last().click();
  let after = before;
  await until(async () => {
    after = (await stateOf(workshop)).motion.at;
    return after.working[0] > before.working[0] + 5;
  }, "the job goes on");
  expect(after.working[1]).toBeCloseTo(0, 4);
  const shift = (at: typeof after) => at.base[1] - at.working[1];
  expect(shift(after) - shift(before)).toBeCloseTo(2.54, 4);
});

it("UV and UD show settings and what helps to find a fault", async () => {
  await command(page, "UV");
  const sheet = page.getByRole("dialog", { name: "Values" });
  await sheet.getByRole("rowheader", { name: /^VS,/ }).waitFor();
  await sheet.getByRole("row", { name: /Data folder/ }).waitFor();
  await page.keyboard.press("Escape");
  await sheet.waitFor({ state: "detached" });
  await command(page, "UD");
  await sheet.getByRole("row").first().waitFor();
  expect(await sheet.getByRole("row").count()).toBeGreaterThan(4);
  expect(await sheet.textContent()).toContain("0.");
  await page.keyboard.press("Escape");
});
