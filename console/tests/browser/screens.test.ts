import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

beforeAll(async () => {
  workshop = await openWorkshop({ parts: ["01-first-cut/first-cut.sbp"], open: "first-cut.sbp" });
  page = await workshop.page();
});
afterAll(() => workshop?.close());

interface Violation {
  id: string;
  nodes: { target: string[]; failureSummary: string }[];
}

/** What axe finds on the page, as lines. */
async function violations(): Promise<string[]> {
  await page.evaluate(axe);
  const found = await page.evaluate(async () => {
    const tool = Reflect.get(window, "axe") as { run(): Promise<{ violations: Violation[] }> };
    return (await tool.run()).violations;
  });
  return found.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")}: ${failureSummary}`),
  );
}

const themes = ["light", "dark", "contrast"];
const routes = ["/", "/edit", "/draw", "/settings", "/help"];

it.each(themes.flatMap((theme) => routes.map((route) => [theme, route] as const)))(
  "has nothing in anybody's way: %s %s",
  async (theme, route) => {
    await page.evaluate((chosen) => localStorage.setItem("kerf.theme", chosen), theme);
    await page.goto(`${workshop.address}${route}`);
    await page.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
    await page.locator(".state", { hasText: "Disarmed" }).waitFor();
    expect(await violations()).toEqual([]);
  },
);

it.each([
  [1280, 720],
  [1280, 800],
  [1024, 768],
])("shows the operator everything without scrolling at %d by %d", async (width, height) => {
  await page.setViewportSize({ width, height });
  for (const face of ["easy", "full"]) {
    await page.evaluate((chosen) => localStorage.setItem("kerf.face", chosen), face);
    await page.goto(workshop.address);
    await page.locator(".location-number").first().waitFor();
    const scrolls = await page.locator(".screen").evaluate((screen) => ({
      down: screen.scrollHeight - screen.clientHeight,
      across: document.documentElement.scrollWidth - innerWidth,
    }));
    expect(scrolls).toEqual({ down: 0, across: 0 });
  }
});

it("sbp_con_position: shows every axis with three decimals and its unit", async () => {
  await page.goto(workshop.address);
  for (const axis of ["X", "Y", "Z"]) {
    expect(await page.locator(`[data-axis="${axis}"]`).textContent()).toMatch(/^-?\d+\.\d{3}$/);
  }
  expect(await page.locator(".location-unit").first().textContent()).toBe("in");
});
