/** Draws the pictures of the book: `npm run figures`. */

import { join, resolve } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, it } from "vitest";
import { Controller } from "../browser/controller";
import { sizes } from "../browser/sizes";
import { act, arm, fullFace, openWorkshop, type Workshop } from "../browser/workshop";

const figures = resolve(import.meta.dirname, "../../../docs/figures");
let workshop: Workshop;
let page: Page;

/** A machine on which nothing has happened yet. */
async function begin(): Promise<void> {
  workshop = await openWorkshop({
    parts: ["03-coaster/coaster.sbp", "10-from-a-drawing/from-a-drawing.rsg"],
    open: "coaster.sbp",
  });
  page = await workshop.page();
  await page.evaluate(() => localStorage.setItem("kerf.theme", "dark"));
  await page.reload();
}

beforeAll(begin);
afterAll(() => workshop?.close());

const picture = (name: string) => page.screenshot({ path: join(figures, `console-${name}.png`) });
const wait = (ms: number) => new Promise((go) => setTimeout(go, ms));

it("the operator's screen in the middle of a cut", async () => {
  await arm(page);
  await page.getByRole("radio", { name: "3D" }).click();
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByRole("button", { name: "OK" }).click();
  await wait(20_000);
  await picture("operator");
  await workshop.close();
});

it("material that is cut", async () => {
  await begin();
  await arm(page);
  await page.getByRole("radio", { name: "3D" }).click();
  await page.getByRole("button", { name: "Stock" }).click();
  for (let n = 0; n < 2; n += 1) await page.getByRole("button", { name: /^Speed/ }).click();
  await page.getByRole("button", { name: "Play the simulation" }).click();
  await wait(8000);
  await picture("stock");
});

it("a fill-in sheet", async () => {
  await fullFace(page);
  await page.getByLabel("Command line").pressSequentially("cc");
  await page.getByRole("dialog").getByRole("textbox").first().fill("4");
  await wait(500);
  await picture("sheet");
  await page.keyboard.press("Escape");
});

it("the keypad", async () => {
  await page.keyboard.press("k");
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  await wait(3000);
  await picture("keypad");
  await page.keyboard.press("Escape");
});

it("the editor", async () => {
  await page.getByRole("link", { name: "Edit" }).click();
  await page.locator(".cm-content").waitFor();
  await wait(1500);
  await picture("editor");
});

it("the drawing", async () => {
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("button", { name: "from-a-drawing.rsg" }).first().click();
  await page.getByLabel("Tool paths").check();
  await wait(1000);
  await picture("drawing");
});

const screens = ["Operate", "Edit", "Draw", "Settings", "Help"];

/** Sheets by their file names, with the actions that open them. */
const sheets: Readonly<Record<string, string>> = {
  probe: "Probe: find a place by touch",
  "height-map": "Height map: probe a surface",
  surfacing: "Surfacing: plane a board",
  tuning: "Steps per millimetre and squareness",
  wiring: "Wire a board of a printer",
};

async function pageOf(size: (typeof sizes)[number]): Promise<Page> {
  await page?.close();
  page = await workshop.page(size, size.width < 1100);
  await page.evaluate(() => localStorage.setItem("kerf.face", "easy"));
  await page.reload();
  await page.locator(".state").waitFor();
  const takes = page.getByRole("button", { name: "Take control" });
  if ((await takes.count()) > 0) await takes.click();
  return page;
}

it.each(sizes)("every screen at $width by $height", async (size) => {
  const shown = await pageOf(size);
  for (const name of screens) {
    await shown.getByRole("link", { name, exact: true }).click();
    await shown.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
    await wait(1500);
    const file = `screen-${name.toLowerCase()}-${size.width}.png`;
    await shown.screenshot({ path: join(figures, file) });
  }
});

it.each([390, 1440])("sheets of the machine, %d wide", async (width) => {
  const size = sizes.find((one) => one.width === width);
  if (!size) throw new Error(`no size is ${width} wide`);
  const shown = await pageOf(size);
  for (const [name, action] of Object.entries(sheets)) {
    await act(shown, action);
    await shown.getByLabel("What to do").waitFor({ state: "detached" });
    await shown.getByRole("dialog").first().waitFor();
    await wait(500);
    await shown.screenshot({ path: join(figures, `sheet-${name}-${width}.png`) });
    await shown.keyboard.press("Escape");
    await shown.getByRole("dialog").first().waitFor({ state: "detached" });
  }
});

it("two machines in one server", async () => {
  await workshop.close();
  const controller = new Controller();
  workshop = await openWorkshop({
    parts: ["03-coaster/coaster.sbp"],
    open: "coaster.sbp",
    also: [`grbl:${await controller.line()}`],
  });
  const shown = await workshop.page({ width: 1440, height: 900 });
  await shown.getByRole("navigation", { name: "Machines" }).waitFor();
  await wait(1500);
  await shown.screenshot({ path: join(figures, "console-machines.png") });
  controller.unplug();
});
