import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;

beforeEach(async () => {
  workshop = await openWorkshop({ rate: 100 });
});
afterEach(() => workshop?.close());

interface Listed {
  readonly shapes: readonly { closed: boolean; points: readonly number[] }[];
}

/** What the server has, to a thousandth. */
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
  await page.getByRole("button", { name: "New", exact: true }).click();
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

it("draws a part from nothing and cuts it, with typed places and keys", async () => {
  const page = await workshop.page();
  await begin(page);
  await page.getByRole("button", { name: "Rectangle" }).press("Enter");
  const type = async (text: string) => {
    await page.keyboard.press("t");
    await page.getByPlaceholder("x,y").fill(text);
    await page.keyboard.press("Enter");
  };
  await type("10mm,10mm");
  await type("@50mm,30mm");
  await expect.poll(() => shapesOf(page)).toEqual([[10, 10, 0, 60, 10, 0, 60, 40, 0, 10, 40, 0]]);
  await page.getByRole("button", { name: "Fillet" }).press("Enter");
  await page.getByLabel("Radius").fill("5mm");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+z");
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("0");
  await page.keyboard.press("Control+y");
  await expect.poll(() => fact(page, "Shapes").textContent()).toBe("1");
  await cut(page);
  expect(workshop.mistakes).toEqual([]);
});
