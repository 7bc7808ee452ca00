import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { actions } from "../../src/actions/registry";
import { drawingWords } from "../../src/app/drawingWords";
import { deskKeys } from "../../src/draw/keys";
import { tools as catalog } from "../../src/draw/tools/catalog";
import { enter, openWorkshop, stateOf, type Workshop } from "./workshop";

let workshop: Workshop;

beforeEach(async () => {
  workshop = await openWorkshop({ rate: 100 });
});
afterEach(() => workshop?.close());

interface Listed {
  readonly shapes: readonly { closed: boolean; points: readonly number[] }[];
}

/** Shapes that the server has, to a thousandth. */
async function shapesOf(page: Page): Promise<number[][]> {
  const list: Listed = await (
    await page.request.get(`${workshop.address}/api/drawing/shapes`)
  ).json();
  return list.shapes.map(({ points }) => points.map((value) => Math.round(value * 1000) / 1000));
}

const fact = (page: Page, name: string) =>
  page.locator(".facts div").filter({ hasText: name }).locator("dd");

async function begin(page: Page): Promise<void> {
  await page.getByRole("link", { name: "Draw" }).click();
  const { drawing } = await stateOf(workshop);
  await page.getByRole("button", { name: "New", exact: true }).click();
  const drop = page.getByRole("button", { name: "Drawing: drop it and begin a new one" });
  if (drawing?.changed && drawing.shapes > 0) await drop.click();
  // The server has begun it: what another one draws from now on is in it.
  await expect
    .poll(async () => (await stateOf(workshop)).drawing?.revision)
    .not.toBe(drawing?.revision);
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("0");
}

/** Makes the program of the drawing, and cuts it. */
async function cut(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Make the part program…" }).click();
  await page.getByRole("button", { name: "Write" }).click();
  const arm = page.getByRole("button", { name: "Arm" });
  const start = page.getByRole("button", { name: "Start" });
  await arm.or(start).first().waitFor();
  if (await arm.isVisible()) await arm.click();
  await start.click();
  // The spindle is about to start.
  await page.getByRole("button", { name: "OK" }).click();
  await page.getByText("finished").waitFor();
}

it("draws a part from nothing and cuts it, with the mouse only", async () => {
  const page = await workshop.page();
  await begin(page);
  const sheet = await page.getByRole("application").boundingBox();
  if (!sheet) throw new Error("there is no sheet");
  const click = (x: number, y: number) => page.mouse.click(sheet.x + x, sheet.y + y);
  await page.getByRole("button", { name: "Rectangle" }).click();
  await click(100, 400);
  await click(500, 100);
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("1");
  await page.getByRole("button", { name: "Circle" }).click();
  await click(300, 250);
  await click(350, 250);
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("2");
  await page.getByRole("button", { name: "Order from a place" }).click();
  await click(20, 480);
  await expect
    .poll(async () => (await shapesOf(page)).map((points) => points.length))
    .toEqual([6, 12]);
  await cut(page);
  expect(workshop.mistakes).toEqual([]);
});

it("draws a part from nothing and cuts it, with the keyboard only", async () => {
  const page = await workshop.page();
  await page.locator(".location-number").first().waitFor();
  await enter(page, "Draw");
  await page.getByRole("application").waitFor();
  await enter(page, "New");
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("0");
  const keys = page.keyboard;
  const type = async (text: string) => {
    await keys.type(text);
    await keys.press("Enter");
  };
  await enter(page, "Rectangle");
  await type("10mm,10mm");
  await type("@50mm,30mm");
  await expect.poll(() => shapesOf(page)).toEqual([[10, 10, 0, 60, 10, 0, 60, 40, 0, 10, 40, 0]]);
  await keys.press("Escape");
  await enter(page, "Circle");
  await type("35mm,25mm");
  await type("5mm");
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("2");
  await keys.press("Escape");
  await keys.press("Control+z");
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("1");
  await keys.press("Control+y");
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("2");
  await enter(page, "Order from a place");
  await type("0,0");
  await expect
    .poll(async () => (await shapesOf(page)).map((points) => points.length))
    .toEqual([6, 12]);
  await keys.press("Escape");
  await enter(page, "Make the part program…");
  await page.getByRole("dialog", { name: "Part program of the tool paths" }).waitFor();
  await keys.press("Enter");
  await page.locator(".job-name", { hasText: "drawing.sbp" }).waitFor();
  await expect.poll(() => page.getByRole("button", { name: "Start" }).isEnabled()).toBe(true);
  await enter(page, "Start");
  await page.getByText("The spindle is about to start.").waitFor();
  await keys.press("Enter");
  await page.getByText("finished").waitFor();
  expect(workshop.mistakes).toEqual([]);
});

/** A drawing of one rectangle. */
async function withRectangle(page: Page): Promise<{ x: number; y: number }> {
  await begin(page);
  const op = { op: "do", clauses: "rect 10,10 60,40; select 1" };
  await page.request.post(`${workshop.address}/api/do/draw`, { data: { op } });
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("1");
  const sheet = await page.getByRole("application").boundingBox();
  if (!sheet) throw new Error("there is no sheet");
  return sheet;
}

it("pro_select_cursor: a red cross-hair while something is to be picked, and nowhere else", async () => {
  const page = await workshop.page();
  await withRectangle(page);
  const cursor = (selector: string) =>
    page.locator(selector).evaluate((element) => getComputedStyle(element).cursor);
  expect(await cursor(".sheet-box")).not.toContain("crosshair");
  await page.getByRole("button", { name: "Move", exact: true }).click();
  expect(await cursor(".sheet-box")).toMatch(/%23e0202b.*crosshair/);
  for (const other of [".drawing-head", ".draw-right", ".toolbox"]) {
    expect(await cursor(other)).not.toContain("crosshair");
  }
  await page.getByRole("button", { name: "All operations…" }).click();
  expect(await cursor(".sheet")).not.toContain("crosshair");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Give the tool up" }).click();
  expect(await cursor(".sheet-box")).not.toContain("crosshair");
});

it("pro_select_menus: everything that a key does has a button, which does the same", async () => {
  const page = await workshop.page();
  const sheet = await withRectangle(page);
  const buttons = async () =>
    page.locator("[data-key]").evaluateAll((all) => all.map((one) => one.getAttribute("data-key")));
  const idle = await buttons();
  await page.getByRole("button", { name: "Move", exact: true }).click();
  await page.mouse.click(sheet.x + 200, sheet.y + 300);
  const unseen = async () => {
    const seen = new Set([...idle, ...(await buttons())]);
    return deskKeys.map(({ key }) => key).filter((key) => !seen.has(key));
  };
  await expect.poll(unseen).toEqual([]);
  await page.locator('[data-key="g"]').click();
  await page.locator(".sheet-status-keys span", { hasText: "square to the base point" }).waitFor();
  await page.locator('[data-key="q"]').click();
  await page.locator('[data-key="arrowup"]').click();
  await page.locator('[data-key="arrowleft"]').click();
  await page.getByText("turned 2°").waitFor();
  await page.locator('[data-key="t"]').click();
  await page.getByPlaceholder("x,y").waitFor();
  await page.keyboard.press("Escape");
  await page.locator('[data-key="escape"]').click();
  await page.locator('[data-key="delete"]').click();
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("0");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("1");
});

it("pro_select_menus: everything that has a key anywhere stands in a list that the mouse opens", async () => {
  const page = await workshop.page();
  await withRectangle(page);
  await page.getByRole("button", { name: "Every action" }).click();
  const list = page.getByRole("listbox", { name: "Actions" });
  const rows = await list.getByRole("option").allTextContents();
  const keyed = actions.filter(({ keys }) => (keys?.length ?? 0) > 0);
  expect(keyed.length).toBeGreaterThan(10);
  const missing = keyed.filter(({ title, keys }) => !rows.includes(title + keys?.join("")));
  expect(missing.map(({ title }) => title)).toEqual([]);
  // What stands there is done by a click.
  const back = keyed.find(({ keys }) => keys?.includes("Ctrl+Z"));
  await list
    .getByRole("option")
    .filter({ hasText: back?.title ?? "" })
    // The list was scrolled this instant; a hand presses longer.
    .click({ delay: 80 });
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("0");
  // So does every tool and every operation of the table.
  const tools = await page.getByRole("navigation", { name: "Drawing tools" }).textContent();
  expect(catalog.filter(({ title }) => !tools?.includes(title))).toEqual([]);
  await page.getByRole("button", { name: "All operations…" }).click();
  const answer = await page.request.get(`${workshop.address}/api/drawing/operations`);
  const table: { name: string }[] = await answer.json();
  const words = (text: string) => drawingWords(text.toLowerCase().replaceAll("-", " "));
  const unlisted = async () => {
    const listed = await page.locator(".operation-list button b").allTextContents();
    const names = new Set(listed.map(words));
    return table.map(({ name }) => name).filter((name) => !names.has(words(name)));
  };
  await expect.poll(unlisted).toEqual([]);
});

it("pro_edit_type_key: Esc in the entry leads back to the mouse", async () => {
  const page = await workshop.page();
  const sheet = await withRectangle(page);
  await page.getByRole("button", { name: "Move", exact: true }).click();
  await page.keyboard.press("t");
  await page.getByPlaceholder("x,y").fill("0,0");
  await page.keyboard.press("Escape");
  await expect.poll(() => page.getByPlaceholder("x,y").count()).toBe(0);
  await page.mouse.click(sheet.x + 200, sheet.y + 300);
  await page.getByText("Where it goes").waitFor();
  await page.keyboard.press("t");
  await page.getByPlaceholder("x,y").fill("@5mm,5mm");
  await page.keyboard.press("Enter");
  await expect.poll(async () => (await shapesOf(page))[0]?.slice(0, 3)).toEqual([15, 15, 0]);
});

it("shows the drawing from the side, from the end and in 3D, and goes back to the top for a tool", async () => {
  const page = await workshop.page();
  await withRectangle(page);
  for (const view of ["Side", "End", "3D"]) {
    await page.getByRole("radio", { name: view }).click();
    await page.getByRole("application", { name: "View of the drawing" }).waitFor();
    await page.getByText(/^z-plane/).waitFor();
  }
  await page.getByRole("button", { name: "Move", exact: true }).click();
  await page.getByRole("application", { name: "Shapes of the drawing" }).waitFor();
  expect(workshop.mistakes).toEqual([]);
});
