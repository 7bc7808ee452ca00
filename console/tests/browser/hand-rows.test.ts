/** Rows of the ledger about moving the tool by the keys of the hand console, which the numeric keypad mimics. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import {
  act,
  arm,
  type Hand,
  hold,
  keysOf,
  openWorkshop,
  stands,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

type Place = readonly [x: number, y: number, z: number];

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ machine: "sim" });
  page = await workshop.page();
  await arm(page);
  await chooses("Hand console");
  await page.getByRole("complementary", { name: "Hand console" }).waitFor();
});
afterAll(() => workshop?.close());

/** An action of the palette. */
async function chooses(words: string) {
  await act(page, words);
}

const placeIn = ({ motion }: Snapshot): Place => {
  const [x = 0, y = 0, z = 0] = motion.at.machine.map((at) => Math.round(at * 1e6) / 1e6 + 0);
  return [x, y, z];
};
const place = async () => placeIn(await stateOf(workshop));
const standing = () => until(() => stands(workshop), "the machine stands");

/** Brings the tool to a place, by the sheet for that. */
async function bring([x, y, z]: Place) {
  await chooses("Move the tool to a place");
  const sheet = page.getByRole("dialog", { name: "Move the tool to" });
  const part = sheet.getByRole("region", { name: "MoveTo", exact: true });
  for (const [letter, value] of Object.entries({ X: x, Y: y, Z: z }))
    await part.getByLabel(letter, { exact: true }).fill(`${value}mm`);
  await part.getByRole("radio", { name: "2D: X and Y, then the others" }).click();
  await part.getByRole("button", { name: "Move", exact: true }).press("Enter");
  await until(async () => {
    const [ax, ay, az] = await place();
    return Math.hypot(ax - x, ay - y, az - z) < 1e-3 && (await stands(workshop));
  }, `the tool is at ${x}, ${y}, ${z}`);
  await page.keyboard.press("Escape");
  await sheet.waitFor({ state: "detached" });
}

/** The digits as they lie on the keypad. */
const digit = (n: number): Hand => keysOf(page, [`Numpad${n}`]);

/** Holds a digit until the tool has gone so far in some direction, and lets go; the way from where it was held. */
async function goes(n: number, mm: number): Promise<{ way: Place; fastest: number }> {
  const from = await place();
  let fastest = 0;
  const far = (now: Snapshot) => {
    fastest = Math.max(fastest, now.motion.speedMmS);
    const [x, y, z] = placeIn(now);
    return Math.max(Math.abs(x - from[0]), Math.abs(y - from[1]), Math.abs(z - from[2])) > mm;
  };
  await hold(workshop, digit(n), far, `${n} moves the tool`);
  await digit(n).up();
  await standing();
  const [x, y, z] = await place();
  return { way: [x - from[0], y - from[1], z - from[2]], fastest };
}

const isSaid = (words: string) => page.getByText(words).first().isVisible();

it("pro_move_arrows_xy: digits move along X, Y and the diagonals for as long as they are held", async () => {
  await bring([500, 500, 0]);
  // A quarter of 200 mm/s on each axis that moves, as `arrows.speed_percent` says at first.
  const speed = 50;
  for (const [n, x, y] of [
    [6, 1, 0],
    [9, 1, 1],
    [8, 0, 1],
    [7, -1, 1],
    [4, -1, 0],
    [1, -1, -1],
    [2, 0, -1],
    [3, 1, -1],
  ] as const) {
    const { way, fastest } = await goes(n, 20);
    const far = Math.max(Math.abs(way[0]), Math.abs(way[1]));
    expect(far, `${n}`).toBeGreaterThan(20);
    expect(fastest, `${n}`).toBeCloseTo(speed * Math.hypot(x, y), 3);
    for (const [at, sign] of [x, y, 0].entries())
      expect(way[at], `${n}`).toBeCloseTo(far * sign, 3);
  }
  // Nothing goes on: it rests where it came to.
  const there = await place();
  await new Promise((resolve) => setTimeout(resolve, 300));
  expect(await place()).toEqual(there);
});

it("pro_move_arrows_z: 5 moves up and 0 down, in Z alone and to Z bottom", async () => {
  await bring([5, 5, -25]);
  const up = await goes(5, 3);
  expect(up.way[2]).toBeGreaterThan(3);
  expect(up.way.slice(0, 2)).toEqual([0, 0]);
  const { bottom } = (await stateOf(workshop)).setup.heights;
  const low = async (now: Snapshot) =>
    placeIn(now)[2] <= bottom && (await isSaid(`Out of bounds: z ends at ${bottom.toFixed(3)}`));
  await hold(workshop, digit(0), low, "0 moves down to Z bottom, and that is said");
  // Still held, it goes no lower.
  await new Promise((resolve) => setTimeout(resolve, 400));
  expect(await place()).toEqual([5, 5, bottom]);
  await digit(0).up();
  await standing();
});

it("pro_move_arrows_limit: the tool rests at the end of the axis, unless movement is not limited", async () => {
  const end = 2500;
  await bring([end - 10, 100, 0]);
  const ends = async (now: Snapshot) =>
    placeIn(now)[0] >= end && (await isSaid(`Out of bounds: x ends at ${end.toFixed(3)}`));
  await hold(workshop, digit(6), ends, "6 moves to the end, and that is said");
  await new Promise((resolve) => setTimeout(resolve, 400));
  expect(await place()).toEqual([end, 100, 0]);
  if (process.env.KERF_SHOTS) await page.screenshot({ path: `${process.env.KERF_SHOTS}/ends.png` });
  await digit(6).up();
  await standing();
  await page.getByRole("link", { name: "Settings" }).click();
  await page.getByLabel("Search settings").fill("axis.limit_movement");
  const before = (await stateOf(workshop)).settings;
  const rows = page.locator(".setting");
  await expect.poll(() => rows.count()).toBe(1);
  await rows.getByRole("radio", { name: "no" }).click();
  await until(async () => (await stateOf(workshop)).settings > before, "movement is not limited");
  await page.getByRole("link", { name: "Operate" }).click();
  const { way } = await goes(6, 15);
  expect(way[0]).toBeGreaterThan(15);
  expect(workshop.mistakes).toEqual([]);
});
