/** Digitizing with the hand console on the operator's screen: seen on the tool path, and cut as it was recorded. */

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import {
  act,
  arm,
  kerf,
  openWorkshop,
  script,
  stands,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const folder = mkdtempSync(join(tmpdir(), "kerf-digitize-"));
  const machine = (...words: string[]) =>
    execFileSync(kerf, ["machine", ...words, "--data", folder], { stdio: "ignore" });
  machine("use", "sim");
  machine("set", "job.origin_mm", "[400, 300]");
  writeFileSync(join(folder, "slot.sbp"), "J2,50,20\nMZ,-3\nM2,150,100\nJZ,0\n");
  workshop = await openWorkshop({ folder, open: "slot.sbp", rate: 50 });
  await script(workshop, "draw", { op: { op: "new" } });
  page = await workshop.page({ width: 1360, height: 900 });
  await page.locator('.path-lines[data-path="all"]').waitFor();
  await arm(page);
  await act(page, "Hand console");
  await panel().waitFor();
  await until(async () => (await stateOf(workshop)).lease !== null, "the page drives");
});
afterAll(() => workshop?.close());

const panel = () => page.getByRole("complementary", { name: "Hand console" });
const lines = async () => (await stateOf(workshop)).handConsole.lines;
const shows = (top: string) => expect.poll(async () => (await lines())[0]).toBe(top);
const points = async () => (await stateOf(workshop)).digitized?.points ?? [];

/** Clicks on keys: words are keys, numbers are their digits. */
async function press(keys: string): Promise<void> {
  for (const word of keys.split(" ")) {
    const parts = /^-?\d+$/.test(word) ? [...word] : [word];
    for (const part of parts) {
      const name = part === "-" ? "Plus minus" : part;
      await panel().getByRole("button", { name, exact: true }).click();
    }
  }
}

/** Drives to a place from the job origin and records it. */
async function record(keys: string, at: readonly number[]): Promise<void> {
  const count = (await points()).length;
  await press(`Func 20 Enter ${keys}`);
  const [x = 0, y = 0] = at;
  await until(async () => {
    const [mx, my] = (await stateOf(workshop)).motion.at.machine;
    return Math.hypot(mx - 400 - x, my - 300 - y) < 1e-3 && (await stands(workshop));
  }, `the tool is at ${x},${y}`);
  await expect.poll(async () => (await lines())[1]).toContain("Cur=");
  await press("Enter");
  await until(async () => (await points()).length === count + 1, "the point is recorded");
}

interface Ink {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  readonly count: number;
  readonly width: number;
  readonly height: number;
}

/** Bounds of what is digitized on the canvas above the tool path, pixels. */
const inked = (): Promise<Ink> =>
  page.locator("canvas.path-marks").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const style = getComputedStyle(document.documentElement);
    const inks = ["--draw-digitized", "--draw-digitized-current"].map((token) => {
      const hex = style.getPropertyValue(token).trim();
      return [1, 3, 5].map((n) => Number.parseInt(hex.slice(n, n + 2), 16));
    });
    const { width, height } = canvas;
    const data = canvas.getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
    const found = { left: width, right: 0, top: height, bottom: 0, count: 0, width, height };
    for (let n = 0; n < data.length; n += 4) {
      const is = (ink: number[]) => ink.every((part, i) => Math.abs(part - (data[n + i] ?? 0)) < 8);
      if (data[n + 3] !== 255 || !inks.some(is)) continue;
      const [x, y] = [(n / 4) % width, Math.floor(n / 4 / width)];
      found.left = Math.min(found.left, x);
      found.right = Math.max(found.right, x);
      found.top = Math.min(found.top, y);
      found.bottom = Math.max(found.bottom, y);
      found.count += 1;
    }
    return found;
  });

/** The disc of a point, and the ring round the current one, reach so far beside its middle, pixels. */
const [disc, ring] = [4.5, 11];

/** Checks where the points lie when a box, mm from home, is in the picture so many times larger. */
async function inThePicture(box: readonly (readonly [number, number])[], message: string) {
  const [[left, bottom], [right, top]] = box as [[number, number], [number, number]];
  await expect
    .poll(
      async () => {
        const { width, height, ...ink } = await inked();
        const mm = 1.05 * Math.max((right - left) / width, (top - bottom) / height);
        const x = (at: number) => width / 2 + (at - (left + right) / 2) / mm;
        const y = (at: number) => height / 2 - (at - (bottom + top) / 2) / mm;
        const off = [
          ink.left - x(400) + disc,
          ink.right - x(520) - ring,
          ink.top - y(360) + ring,
          ink.bottom - y(300) - disc,
        ];
        return Math.max(...off.map(Math.abs));
      },
      { message },
    )
    .toBeLessThan(2.5);
}

it("pro_digitize_d30__on_the_operators_screen: the tool path shows the points, where they are on the table", async () => {
  await press("Func 70 Enter");
  await expect.poll(async () => (await lines())[1]).toBe("Cur=0 of 0");
  expect((await inked()).count).toBe(0);
  await record("0 Enter 0 Enter", [0, 0]);
  await record("120 Enter 0 Enter", [120, 0]);
  await record("120 Enter 60 Enter", [120, 60]);
  await press("Func 30 Enter");
  await inThePicture(
    [
      [400, 300],
      [520, 360],
    ],
    "the points fill the picture",
  );
  expect((await inked()).count).toBeGreaterThan(400);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/operate-d30.png` });
});

it("pro_digitize_d31__on_the_operators_screen: the tool path and the points", async () => {
  const { opened } = await stateOf(workshop);
  const key = opened?.preview.state === "ready" ? opened.preview.key : "";
  const answer = await fetch(`${workshop.address}/api/preview/${key}`);
  const { bounds } = (await answer.json()) as { bounds: [number[], number[]] };
  const [x = 0, y = 0] = bounds[0];
  const [right = 0, top = 0] = bounds[1];
  expect(right, "the tool path lies elsewhere").toBeLessThan(400);
  await press("Func 31 Enter");
  await inThePicture(
    [
      [Math.min(x, 400), Math.min(y, 300)],
      [Math.max(right, 520), Math.max(top, 360)],
    ],
    "both are in the picture",
  );
});

it("pro_digitize_d32__on_the_operators_screen: the machine's bounds with the points", async () => {
  const [right, top] = (await stateOf(workshop)).setup.reach;
  expect(right).toBeGreaterThan(520);
  await press("Func 32 Enter");
  await inThePicture(
    [
      [0, 0],
      [right, top],
    ],
    "the machine is in the picture",
  );
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/operate-d32.png` });
});

it("pro_digitize_d33__on_the_operators_screen: twice as much, about the same middle", async () => {
  await press("Func 30 Enter");
  await expect.poll(async () => (await inked()).right - (await inked()).left).toBeGreaterThan(400);
  const near = await inked();
  await press("Func 33 Enter");
  const wide = ({ left, right }: Ink) => right - left - disc - ring;
  await expect.poll(async () => wide(await inked()) / wide(near)).toBeCloseTo(0.5, 1);
  const far = await inked();
  expect(Math.abs(far.left + far.right - near.left - near.right)).toBeLessThan(8);
});

it("pro_digitize_d12__on_the_operators_screen: a shape in 3D is cut as deep as each point was recorded", async () => {
  await press("Func 15 Enter Enter");
  await until(async () => (await points()).length === 0, "begun anew");
  await press("-");
  await shows("Digitize: 2D Arc");
  await press("Func 12 Enter");
  await shows("Digitize: 3D Point");
  expect((await stateOf(workshop)).digitized).toMatchObject({ threeD: true, nextArc: false });
  await record("0 Enter 0 Enter -22 Enter", [0, 0]);
  await record("120 Enter 0 Enter -25 Enter", [120, 0]);
  expect((await points()).map(({ at }) => at[2])).toEqual([-22, -25]);
  await press("Func 8 Enter");
  await until(async () => (await stateOf(workshop)).drawing?.shapes === 1, "the shape");
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Machine", exact: true }).click();
  let deepest: number | undefined;
  await until(async () => {
    const { opened } = await stateOf(workshop);
    if (opened?.name === "slot.sbp" || opened?.preview.state !== "ready") return false;
    const answer = await fetch(`${workshop.address}/api/preview/${opened.preview.key}`);
    // Settings that came meanwhile have it planned anew.
    if (!answer.ok) return false;
    const { bounds } = (await answer.json()) as { bounds: [number[], number[]] };
    deepest = bounds[0][2];
    return true;
  }, "planned");
  expect(deepest, "the deepest cut").toBeCloseTo(-25, 3);
  expect(workshop.mistakes).toEqual([]);
});
