/**
 * Every sheet that an action opens, at every size, beside the bar of machines: nothing lies over anything and nothing
 * is cut off, in English and in German; and nothing is in anybody's way in any theme.
 */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { german } from "../../src/words/german/german";
import { Controller } from "./controller";
import { overlaps } from "./overlaps";
import { sizes, themes } from "./sizes";
import { act, openWorkshop, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;

beforeAll(async () => {
  controller = new Controller();
  const port = await controller.port();
  workshop = await openWorkshop({
    parts: ["01-first-cut/first-cut.sbp"],
    open: "first-cut.sbp",
    controller: `grbl:${port}`,
    also: ["sim"],
  });
});
afterAll(async () => {
  await workshop?.close();
  controller?.unplug();
});

/** The action that opens each sheet. */
const sheets: Readonly<Record<string, string>> = {
  files: "Open a file",
  scratch: "Scratch pad",
  nudge: "Nudge the workpiece",
  values: "Values and variables",
  recorder: "Recorded commands",
  tools: "Virtual tools",
  moveTo: "Move the tool to a place, or home",
  probe: "Probe: find a place by touch, set zero there",
  heightMap: "Height map: probe a surface, cut along it",
  surfacing: "Surfacing: plane a board or the table",
  tuning: "Steps per millimetre and squareness, from what was measured",
  wiring: "Wire a board of a printer",
  zeros: "Zero points of the controller: G54 to G59.3",
  controllerCard: "Card of the controller: list, upload, run, follow",
  controllerLines: "Console of the controller: what is sent and answered",
  warmUp: "Spindle warm-up: steps of speed and time",
  controllerSettings: "Settings of the controller: see, change, back up, compare",
  toolTable: "Tools by their numbers: lengths, changing and measuring them",
  samples: "Sample answers of the open file",
  history: "History of runs",
  todo: "Jobs to do",
  macros: "Macros: commands of one's own",
  timing: "Timing chart",
  setup: "Set up the machine, step by step",
  keys: "Keys of actions",
};

/** Sheets with tests of their own, because something else opens them, or another machine has them. */
const elsewhere = [
  ...["command", "keypad", "palette", "versions", "bin", "confirm", "replace"],
  ...["inputs", "ports", "loadSettings"],
];

it("no sheet of the page is forgotten", () => {
  const source = readFileSync(join(import.meta.dirname, "../../src/app/OpenSheet.tsx"), "utf8");
  const kinds = [...source.matchAll(/case "(\w+)":/g)].map(([, kind]) => kind);
  expect([...Object.keys(sheets), ...elsewhere].sort()).toEqual(kinds.sort());
});

/** Puts a theme on, as the settings do. */
const wear = (page: Page, theme: string) =>
  page.evaluate((chosen) => document.documentElement.setAttribute("data-theme", chosen), theme);

async function open(page: Page, name: string, title: string): Promise<void> {
  await act(page, title);
  await page.getByLabel(/^(?:What to do|Was zu tun ist)$/).waitFor({ state: "detached" });
  await page.getByRole("dialog").first().waitFor();
  if (process.env.KERF_SHOTS) {
    const { width } = page.viewportSize() ?? { width: 0 };
    const language = await page.evaluate(() => document.documentElement.lang);
    const path = join(process.env.KERF_SHOTS, `${name}-${language}-${width}.png`);
    await page.screenshot({ path });
  }
}

async function shut(page: Page): Promise<void> {
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").first().waitFor({ state: "detached" });
}

async function pageOf(size: { width: number; height: number }, language: string): Promise<Page> {
  const page = await workshop.page(size, size.width < 1100);
  await page.evaluate((chosen) => localStorage.setItem("kerf.language", chosen), language);
  await page.reload();
  await page.locator(".state").waitFor();
  return page;
}

it.each(sizes.flatMap((size) => ["en", "de"].map((language) => ({ ...size, language }))))(
  "nothing lies over anything on any sheet, at $width by $height, language $language",
  async ({ language, ...size }) => {
    const page = await pageOf(size, language);
    const found: string[] = [];
    for (const [name, title] of Object.entries(sheets)) {
      await open(page, name, language === "de" ? (german[title] ?? title) : title);
      found.push(...(await overlaps(page)).map((fault) => `${name}: ${fault}`));
      await shut(page);
    }
    expect(found).toEqual([]);
    await page.close();
  },
);

it.each(Object.entries(sheets))("has nothing in anybody's way: %s", async (name, title) => {
  const page = await pageOf({ width: 1024, height: 768 }, "en");
  await open(page, name, title);
  const found: string[] = [];
  for (const theme of themes) {
    await wear(page, theme);
    found.push(...(await violations(page)).map((fault) => `${theme}: ${fault}`));
  }
  expect(found).toEqual([]);
  await page.close();
});
