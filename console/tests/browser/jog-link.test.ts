/** A jog over a bad link: what a hand does not hold for sure, does not move. */

import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import { asUsual, openProxy, type RoughLink } from "./proxy";
import {
  arm,
  comesToRest,
  hold,
  keysOf,
  moment,
  openWorkshop,
  stands,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let proxy: RoughLink;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ isDeaf: true });
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  proxy = await openProxy(workshop.address);
  page = await workshop.browser.newPage({ viewport: { width: 1280, height: 720 } });
  await page.goto(proxy.address);
  const drives = page.getByRole("button", { name: "Take control" });
  await page.locator(".state", { hasText: /Disarmed|Ready/ }).waitFor();
  if ((await drives.count()) > 0) await drives.click();
  await arm(page);
  await page.getByRole("button", { name: "Move tool" }).click();
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
});
afterEach(async () => {
  proxy.close();
  await page.close();
  // The keypad stays open for whoever comes; nobody does.
  await comesToRest(workshop);
});

const dead = { copies: 0, afterMs: 0 };

/** Seconds that it goes on at the speed it had: a quarter of a second unheard, the ramp, and what a busy
 * computer adds. */
const mostSeconds = 1;

/** Location of X and motion of the machine, as the server knows them. */
async function watched(): Promise<{ x: number; moves: boolean }> {
  const { machine, motion } = await stateOf(workshop);
  return { x: motion.at.working[0], moves: machine.state === "jogging" };
}

/** State of the machine when the link becomes bad. */
interface Moving {
  readonly x: number;
  readonly speed: number;
  readonly atMs: number;
}

/** Presses the key and waits until the machine moves at its full speed; where it was then. */
async function jogs(): Promise<Moving> {
  const full = (await stateOf(workshop)).speeds.cutMmS[0];
  let from: Moving = { x: 0, speed: 0, atMs: 0 };
  const goes = ({ motion }: Snapshot) => {
    from = { x: motion.at.working[0], speed: motion.speedMmS, atMs: performance.now() };
    return motion.speedMmS > 0.98 * full;
  };
  await hold(workshop, keysOf(page, ["ArrowRight"]), goes, "the machine moves");
  return from;
}

/** Waits until nothing moves, and tells how far that was from where the link became bad. */
async function stops(what: string, from: Moving): Promise<void> {
  await until(() => stands(workshop), `${what}: it stops`);
  const wayMm = (await watched()).x - from.x;
  const tookMs = Math.round(performance.now() - from.atMs);
  console.log(`${what}: stands after ${tookMs} ms and ${wayMm.toFixed(1)} mm`);
  expect(wayMm, what).toBeLessThan(from.speed * mostSeconds);
}

/** Nothing moves for a while. */
async function stays(): Promise<void> {
  const { x } = await watched();
  await moment(600);
  expect(await watched()).toEqual({ x, moves: false });
}

it("a link that loses everything stops the jog, and nothing begins again with the link", async () => {
  const from = await jogs();
  proxy.fromPage = () => dead;
  await stops("every message lost", from);
  proxy.fromPage = () => asUsual;
  await stays();
  await page.keyboard.up("ArrowRight");
});

it("a link that loses every other message does not stutter", async () => {
  let n = 0;
  proxy.fromPage = (text) => {
    n += 1;
    return text.includes("jogRenew") && n % 2 === 0 ? dead : asUsual;
  };
  // A busy computer may itself be silent for a quarter of a second; then it has to stop, and is pressed again.
  let from: Moving | undefined;
  await until(async () => {
    from = await jogs();
    for (let look = 0; look < 10; look += 1) {
      await moment(70);
      if ((await watched()).moves) continue;
      await page.keyboard.up("ArrowRight");
      await until(() => stands(workshop), "it stands");
      return false;
    }
    return true;
  }, "it goes on for a while");
  if (!from) throw new Error("it moved");
  from = { ...from, x: (await watched()).x };
  await page.keyboard.up("ArrowRight");
  await stops("half of the renewals lost, key let go", from);
});

it("a key that is let go while its message is lost stops the jog all the same", async () => {
  proxy.fromPage = (text) => (text.includes("jogStop") ? dead : asUsual);
  const from = await jogs();
  await page.keyboard.up("ArrowRight");
  await stops("only the stop is lost", from);
});

it("renewals that come late do not keep it moving, and do not move it again", async () => {
  const from = await jogs();
  proxy.fromPage = () => ({ copies: 1, afterMs: 800 });
  await stops("every message 800 ms late", from);
  await stays();
  await page.keyboard.up("ArrowRight");
  await stays();
});

it("messages that come twice move it once, and a start that comes again moves nothing", async () => {
  proxy.fromPage = () => ({ copies: 2, afterMs: 0 });
  const from = await jogs();
  await page.keyboard.up("ArrowRight");
  await stops("every message doubled, key let go", from);
  const starts = proxy.heard.filter(({ text }) => text.includes("jogStart"));
  expect(starts.length).toBeGreaterThan(0);
  for (const { text } of starts) proxy.again(text);
  await stays();
});

it("a slow link moves by steps only", async () => {
  proxy.fromServer = () => ({ copies: 1, afterMs: 200 });
  await page.getByText("The link is slow: only fixed distances move.").waitFor();
  const { x } = await watched();
  await page.keyboard.press("ArrowRight", { delay: 500 });
  expect((await watched()).x).toBe(x);
  await page.keyboard.press("d");
  // Held until it is made: a step ends early where the computer is silent for a quarter of a second.
  await until(async () => {
    const { x: from } = await watched();
    const begun = ({ motion }: Snapshot) => motion.at.working[0] > from;
    const hand = keysOf(page, ["ArrowRight"]);
    const stood = await hold(workshop, hand, begun, "the step begins");
    await until(() => stands(workshop), "the step ends");
    await page.keyboard.up("ArrowRight");
    const way = (await watched()).x - stood.motion.at.working[0];
    expect(way).toBeLessThan(2.55);
    return way > 2.53;
  }, "a whole step");
});

it("a link that ends stops the jog", async () => {
  const from = await jogs();
  proxy.close();
  await stops("the link ends", from);
  await page.getByText("No link to the machine.", { exact: true }).waitFor();
});
