/** A beginner's first part, drawn with the mouse: what would be scrap is asked, cut otherwise, or told. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import type { ToolPaths } from "../../src/wire/messages";
import { openWorkshop, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  page = await workshop.page();
  await page.goto(`${workshop.address}/draw`);
  await page.getByRole("application").waitFor();
});
afterAll(() => workshop?.close());

const shapes = async () => (await stateOf(workshop)).drawing?.shapes ?? 0;

beforeEach(async () => {
  for (let n = 0; n < 3 && (await page.getByRole("dialog").count()) > 0; n += 1) {
    await page.keyboard.press("Escape");
  }
  const fresh = (await shapes()) === 0;
  await page.getByRole("button", { name: "New", exact: true }).click();
  const drop = page.getByRole("button", { name: "Drawing: drop it and begin a new one" });
  if (!fresh) await drop.click();
  await until(async () => (await shapes()) === 0, "a new drawing");
});

async function click(x: number, y: number): Promise<void> {
  const sheet = await page.getByRole("application").boundingBox();
  if (!sheet) throw new Error("there is no sheet");
  await page.mouse.click(sheet.x + x, sheet.y + y);
}

/** Draws with a tool of the toolbox, click by click; the number of shapes then. */
async function draw(tool: string, corners: readonly [number, number][], count: number) {
  await page.getByRole("button", { name: tool, exact: true }).click();
  for (const [x, y] of corners) await click(x, y);
  await until(async () => (await shapes()) === count, `${count} shapes`);
  await page.keyboard.press("Escape");
}

/** A plate, and a circle in it that is drawn after it. */
async function plate(): Promise<void> {
  await draw(
    "Rectangle",
    [
      [100, 400],
      [500, 100],
    ],
    1,
  );
  await draw(
    "Circle",
    [
      [300, 250],
      [350, 250],
    ],
    2,
  );
}

/** The shapes whose paths are cut, in order, each with its group. */
async function cut(): Promise<string[]> {
  const answer = await page.request.get(`${workshop.address}/api/drawing/paths`);
  const { paths }: ToolPaths = await answer.json();
  return paths.map(({ number, group }) => `${number} ${group}`);
}

/** Opens the sheet of an operation from the toolbox. */
async function sheetOf(button: string, fields: Readonly<Record<string, string>>) {
  await page.getByRole("button", { name: button }).click();
  const sheet = page.getByRole("dialog");
  for (const [label, text] of Object.entries(fields)) {
    await sheet.getByRole("textbox", { name: new RegExp(`^${label}\\W*$`) }).fill(text);
  }
  return sheet;
}

const told = () => page.locator(".told");

it("cuts the hole of a plate before the plate, and tells when an order by hand does not", async () => {
  await plate();
  expect(await cut()).toEqual(["2 black", "1 black"]);
  const sheet = await sheetOf("Order…", { Shapes: "1,2" });
  await sheet.getByRole("button", { name: "Apply" }).click();
  await page.keyboard.press("Escape");
  await told().getByText("comes free before shape 2 in it is cut").waitFor();
  expect(await cut()).toEqual(["1 black", "2 black"]);
});

for (const [button, name] of [
  ["Pocket…", "pocket"],
  ["Engrave…", "engrave"],
] as const) {
  it(`asks how deep to ${name}, and cuts the outline no more unless asked`, async () => {
    await draw(
      "Rectangle",
      [
        [150, 350],
        [350, 200],
      ],
      1,
    );
    await page.getByRole("button", { name: "Select all" }).click();
    const sheet = await sheetOf(button, { Tool: "5mm" });
    await sheet.getByRole("button", { name: "Apply" }).click();
    await sheet.locator(".field-error").first().waitFor();
    expect(await shapes()).toBe(1);
    await sheet.getByRole("textbox", { name: /^Depth/ }).fill("2mm");
    await sheet.getByRole("button", { name: "Apply" }).click();
    await sheet.getByText("in layer white now, which is off: only the area is cut").waitFor();
    const groups = new Set((await cut()).map((path) => path.split(" ")[1]));
    expect([...groups]).toEqual(["blue"]);
    const { drawing } = await stateOf(workshop);
    expect(drawing?.groups.find(({ name }) => name === "blue")?.height).toBe(-2);
    // Taken back, and asked to be cut too.
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+z");
    await until(async () => (await shapes()) === 1, "the pocket is taken back");
    const again = await sheetOf(button, { Tool: "5mm", Depth: "2mm" });
    await again.getByLabel("Cut outlines").check();
    await again.getByRole("button", { name: "Apply" }).click();
    await until(async () => (await shapes()) > 1, "the pocket");
    expect(await cut()).toContain("1 black");
  });
}

it("tells what a tag leaves between the walls, and when the part would be loose", async () => {
  await draw(
    "Rectangle",
    [
      [100, 400],
      [500, 100],
    ],
    1,
  );
  const sheet = await sheetOf("Settings…", { Offset: "3mm", Tab: "11mm" });
  await sheet.getByRole("button", { name: "Apply" }).click();
  await told()
    .getByText(/leaves a bridge of (0\.197|0\.1969) in between the walls/)
    .waitFor();
  await page.keyboard.press("Escape");
  const again = await sheetOf("Settings…", { Tab: "5mm" });
  await again.getByRole("button", { name: "Apply" }).click();
  await told().getByText("leaves nothing between the walls").waitFor();
  expect(await told().textContent()).toContain("loose");
  expect(workshop.mistakes).toEqual([]);
});
