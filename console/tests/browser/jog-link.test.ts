/** A jog over a bad link: what a hand does not hold for sure, does not move. */

import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, expect, it } from "vitest";
import { asUsual, openProxy, type RoughLink } from "./proxy";
import { arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let proxy: RoughLink;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
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
  await settled();
  // The keypad stays open for whoever comes; nobody does.
  await script(workshop, "stop");
  await until(
    async () => (await stateOf(workshop)).machine.state === "idle",
    "the keypad is closed",
  );
});

const wait = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
const dead = { copies: 0, afterMs: 0 };

/** Longest time of a stop: a quarter of a second unheard, the ramp, and what a busy computer adds. */
const mostMs = 1200;

/** Where X is and whether the machine moves, as the server knows it. */
async function watched(): Promise<{ x: number; moves: boolean }> {
  const { machine, motion } = await stateOf(workshop);
  return { x: motion.at.working[0], moves: machine.state === "jogging" };
}

/** Waits until nothing moves; how long that took and how far X went meanwhile. */
async function settled(): Promise<{ tookMs: number; wayMm: number }> {
  const [begin, { x }] = [performance.now(), await watched()];
  let now = await watched();
  while (now.moves) {
    expect(performance.now() - begin, "it stops").toBeLessThan(10_000);
    await wait(5);
    now = await watched();
  }
  return { tookMs: performance.now() - begin, wayMm: now.x - x };
}

/** Presses the key and waits until the machine moves; over a link that is slow for a moment it makes one
 * step only, then the key is pressed again. */
async function jogs(): Promise<void> {
  const { x } = await watched();
  const goes = async () => {
    const now = await watched();
    return now.moves && now.x > x + 1;
  };
  await until(async () => {
    await page.keyboard.down("ArrowRight");
    for (let look = 0; look < 60; look += 1) {
      if (await goes()) return true;
      await wait(50);
    }
    await page.keyboard.up("ArrowRight");
    return false;
  }, "the machine moves");
}

/** Nothing moves for a while. */
async function stays(): Promise<void> {
  const { x } = await watched();
  await wait(600);
  expect(await watched()).toEqual({ x, moves: false });
}

const told = (what: string, { tookMs, wayMm }: { tookMs: number; wayMm: number }) =>
  console.log(`${what}: stands after ${Math.round(tookMs)} ms and ${wayMm.toFixed(1)} mm`);

it("a link that loses everything stops the jog, and nothing begins again with the link", async () => {
  await jogs();
  proxy.fromPage = () => dead;
  const stop = await settled();
  told("every message lost", stop);
  expect(stop.tookMs).toBeLessThan(mostMs);
  proxy.fromPage = () => asUsual;
  await stays();
  await page.keyboard.up("ArrowRight");
});

it("a link that loses every other message does not stutter", async () => {
  let n = 0;
  await jogs();
  proxy.fromPage = (text) => {
    n += 1;
    return text.includes("jogRenew") && n % 2 === 0 ? dead : asUsual;
  };
  for (let look = 0; look < 10; look += 1) {
    await wait(70);
    expect((await watched()).moves).toBe(true);
  }
  await page.keyboard.up("ArrowRight");
  const stop = await settled();
  told("half of the renewals lost, key let go", stop);
  expect(stop.tookMs).toBeLessThan(mostMs);
});

it("a key that is let go while its message is lost stops the jog all the same", async () => {
  proxy.fromPage = (text) => (text.includes("jogStop") ? dead : asUsual);
  await jogs();
  await page.keyboard.up("ArrowRight");
  const stop = await settled();
  told("only the stop is lost", stop);
  expect(stop.tookMs).toBeLessThan(mostMs);
});

it("renewals that come late do not keep it moving, and do not move it again", async () => {
  await jogs();
  proxy.fromPage = () => ({ copies: 1, afterMs: 800 });
  const stop = await settled();
  told("every message 800 ms late", stop);
  expect(stop.tookMs).toBeLessThan(mostMs);
  await stays();
  await page.keyboard.up("ArrowRight");
  await stays();
});

it("messages that come twice move it once, and a start that comes again moves nothing", async () => {
  proxy.fromPage = () => ({ copies: 2, afterMs: 0 });
  await jogs();
  await page.keyboard.up("ArrowRight");
  const stop = await settled();
  told("every message doubled, key let go", stop);
  expect(stop.tookMs).toBeLessThan(mostMs);
  const starts = proxy.heard.filter(({ text }) => text.includes("jogStart"));
  expect(starts.length).toBeGreaterThan(0);
  for (const { text } of starts) proxy.again(text);
  await stays();
});

it("a slow link moves by steps only", async () => {
  proxy.fromServer = () => ({ copies: 1, afterMs: 200 });
  await page.getByText("The link is slow: only fixed distances move.").waitFor();
  const { x } = await watched();
  await page.keyboard.down("ArrowRight");
  await wait(500);
  await page.keyboard.up("ArrowRight");
  expect((await watched()).x).toBe(x);
  await page.keyboard.press("d");
  await page.keyboard.press("ArrowRight", { delay: 600 });
  await settled();
  expect((await watched()).x - x).toBeCloseTo(2.54, 2);
});

it("a link that ends stops the jog", async () => {
  await jogs();
  proxy.close();
  const stop = await settled();
  told("the link ends", stop);
  expect(stop.tookMs).toBeLessThan(mostMs);
  await page.getByText("No link to the machine.", { exact: true }).waitFor();
});
