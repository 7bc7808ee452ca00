import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import { overlaps } from "./overlaps";
import { phone, sizes, themes } from "./sizes";
import {
  act,
  arm,
  comesToRest,
  type Hand,
  hold,
  openWorkshop,
  script,
  stands,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({ parts: ["01-first-cut/first-cut.sbp"], open: "first-cut.sbp" });
  const ask = 'INPUT "How deep" &depth\nMSGBOX(Is it clamped?, YesNo)\nEND\n';
  writeFileSync(join(workshop.parts, "ask.sbp"), ask);
  const draw = (op: object) => script(workshop, "draw", { op });
  expect(await draw({ op: "new" })).toBe(200);
  expect(await draw({ op: "do", clauses: "line 0,0 100,0; line 0,40 100,40" })).toBe(200);
  expect(await draw({ op: "save", name: "part.rsg" })).toBe(200);
  expect(await script(workshop, "machine", { drawing: "part.rsg", anew: false })).toBe(200);
  expect(await script(workshop, "open", { name: "first-cut.sbp" })).toBe(200);
  writeFileSync(join(workshop.parts, "long.sbp"), "JZ,0.5\nMX,20\nMX,0\nEND\n");
});
afterAll(() => workshop?.close());
afterEach(async () => {
  await Promise.all(workshop.pages.map((page) => page.close()));
  await comesToRest(workshop);
});

const routes = ["/", "/edit", "/draw", "/settings", "/help"];
/** Folder of the pictures that are looked at. */
const shots = process.env.KERF_SHOTS;
async function photograph(page: Page, name: string): Promise<void> {
  const { width = 0, height = 0 } = page.viewportSize() ?? {};
  if (shots) await page.screenshot({ path: join(shots, `${name}-${width}x${height}.png`) });
}

/** Puts a theme on, as the settings do. */
const wear = (page: Page, theme: string) =>
  page.evaluate((chosen) => document.documentElement.setAttribute("data-theme", chosen), theme);

/** Faults in the layout of a page, in every theme. */
async function faults(page: Page, words: string): Promise<string[]> {
  const found: string[] = [];
  for (const theme of themes) {
    await wear(page, theme);
    found.push(...(await overlaps(page)).map((fault) => `${words}, ${theme}: ${fault}`));
  }
  return found;
}

it.each(sizes)(
  "nothing lies over anything, or out of reach, at $width by $height",
  async (size) => {
    const page = await workshop.page(size, size.width < 1100);
    const found: string[] = [];
    for (const face of ["easy", "full"]) {
      await page.evaluate((chosen) => localStorage.setItem("kerf.face", chosen), face);
      for (const route of face === "easy" ? routes : ["/"]) {
        await page.goto(`${workshop.address}${route}`);
        await page.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
        await page.locator(".state", { hasText: /Disarmed|Ready/ }).waitFor();
        found.push(...(await faults(page, `${face} ${route}`)));
      }
    }
    expect(found).toEqual([]);
  },
);

it.each(sizes)(
  "nothing lies over a job and its paths, nor over points that are digitized, at $width by $height",
  async (size) => {
    expect(await script(workshop, "open", { name: "part.rsm" })).toBe(200);
    const page = await workshop.page(size, size.width < 1100);
    const found: string[] = [];
    for (const face of ["easy", "full"]) {
      await page.evaluate((chosen) => localStorage.setItem("kerf.face", chosen), face);
      await page.goto(`${workshop.address}/job`);
      await page.locator(".path-row").first().waitFor();
      found.push(...(await faults(page, `${face}, a job`)));
      await photograph(page, `job-${face}`);
    }
    await digitize(page);
    found.push(...(await faults(page, "digitizing")));
    await photograph(page, "digitize");
    await points(page).getByRole("button", { name: "Exit", exact: true }).click();
    await page.locator(".path-row").first().waitFor();
    expect(await script(workshop, "open", { name: "first-cut.sbp" })).toBe(200);
    expect(found).toEqual([]);
  },
);

const points = (page: Page) => page.getByRole("region", { name: "Digitize" });

/** Begins to digitize from the palette, and waits for the keys. */
async function digitize(page: Page): Promise<void> {
  await arm(page);
  await act(page, "Digitize");
  await points(page).getByRole("button", { name: "Record", exact: true }).waitFor();
}

/** A finger on a button, until it is lifted. */
async function fingerOn(page: Page, name: string): Promise<Hand> {
  const finger = await page.context().newCDPSession(page);
  const box = await page.getByRole("button", { name, exact: true }).boundingBox();
  if (!box) throw new Error(`${name} is not in sight`);
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const touch = (type: "touchStart" | "touchEnd", touchPoints: (typeof at)[]) =>
    finger.send("Input.dispatchTouchEvent", { type, touchPoints });
  return {
    down: async () => void (await touch("touchStart", [at])),
    up: async () => void (await touch("touchEnd", [])),
  };
}

const keypad = (page: Page) => page.getByRole("dialog", { name: "Keypad" });

it.each(sizes)("by touch at $width by $height: arm, jog, cut, hold, stop", async (size) => {
  const page = await workshop.page(size, true);
  await page.evaluate(() => localStorage.setItem("kerf.face", "easy"));
  await page.goto(workshop.address);
  if ((await stateOf(workshop)).machine.armed) await script(workshop, "disarm");
  await page.getByRole("button", { name: "Arm", exact: true }).tap();
  await page.getByRole("button", { name: /^Move tool/ }).tap();
  await keypad(page).getByRole("radio", { name: "0.1", exact: true }).tap();
  const before = (await stateOf(workshop)).motion.at.working[0];
  const finger = await fingerOn(page, "X plus");
  const goes = ({ motion }: Snapshot) => motion.at.working[0] > before + 2;
  await hold(workshop, finger, goes, "a finger moves the tool");
  await finger.up();
  await until(() => stands(workshop), "it stands");
  // The locations stay in sight beside the keypad or above it.
  const [digits, sheet] = await Promise.all([
    page.locator("[data-axis=Z]").boundingBox(),
    keypad(page).boundingBox(),
  ]);
  const apart =
    (digits?.y ?? 0) + (digits?.height ?? 0) <= (sheet?.y ?? 0) ||
    (digits?.x ?? 0) + (digits?.width ?? 0) <= (sheet?.x ?? 0);
  expect(apart).toBe(true);
  expect(await faults(page, "keypad")).toEqual([]);
  await page.getByRole("button", { name: "Close" }).tap();
  await page.getByRole("button", { name: /^Choose file/ }).tap();
  await page.getByRole("option", { name: /long\.sbp/ }).tap();
  await page.locator(".job-name", { hasText: "long.sbp" }).waitFor();
  await page.getByRole("button", { name: "Start", exact: true }).tap();
  await until(async () => (await stateOf(workshop)).machine.state === "running", "it runs");
  await page.getByRole("button", { name: "Hold" }).tap();
  await page.getByRole("button", { name: "Resume" }).tap();
  await page.getByRole("button", { name: "STOP" }).tap();
  await until(async () => (await stateOf(workshop)).machine.state === "stopped", "it stops");
  expect(await faults(page, "stopped")).toEqual([]);
  await page.getByRole("dialog").getByRole("button", { name: "Quit" }).tap();
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "it is over");
});

it("a job that asks is answered on a phone", async () => {
  const page = await workshop.page(phone, true);
  await script(workshop, "arm");
  await page.getByRole("button", { name: /^Choose file/ }).tap();
  await page.getByRole("option", { name: /ask\.sbp/ }).tap();
  await page.locator(".job-name", { hasText: "ask.sbp" }).waitFor();
  await page.getByRole("button", { name: "Start", exact: true }).tap();
  await page.getByRole("dialog").getByRole("textbox").fill("0.25");
  expect(await faults(page, "input")).toEqual([]);
  await page.getByRole("dialog").getByRole("button", { name: "OK" }).tap();
  await page.getByRole("dialog").getByRole("button", { name: "Yes" }).tap();
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "it is over");
});

it("the hand console leaves the buttons of Move the tool to free", async () => {
  const page = await workshop.page({ width: 1280, height: 720 });
  for (const action of ["Hand console", "Move the tool to"]) {
    await act(page, action);
  }
  await page.getByRole("dialog", { name: "Move the tool to" }).waitFor();
  await page.getByLabel("Hand console").first().waitFor();
  expect(await overlaps(page)).toEqual([]);
});
