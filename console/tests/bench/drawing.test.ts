/** Measures the time of a frame of a large drawing: `npm run bench`. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "../browser/workshop";
import { type Figure, tell } from "./record";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop();
});
afterAll(async () => {
  await workshop?.close();
  tell("the console's drawing", figures);
});

const figures: Figure[] = [];

/** Frames that are measured. */
const frames = 120;

/** Wavy closed lines of a hundred segments each, side by side, as DXF. */
function waves(segments: number): string {
  const pairs: (string | number)[] = [0, "SECTION", 2, "ENTITIES"];
  const rows = Math.ceil(Math.sqrt(segments / 100));
  for (let n = 0; n < segments / 100; n += 1) {
    const [x, y] = [(n % rows) * 12, Math.floor(n / rows) * 12];
    pairs.push(0, "POLYLINE", 8, 0, 66, 1, 70, 1);
    for (let k = 0; k < 100; k += 1) {
      const [turn, r] = [(k * Math.PI) / 50, 4 + Math.sin(k * 0.9)];
      pairs.push(0, "VERTEX", 8, 0, 10, x + r * Math.cos(turn), 20, y + r * Math.sin(turn));
    }
    pairs.push(0, "SEQEND");
  }
  pairs.push(0, "ENDSEC", 0, "EOF");
  return `${pairs.join("\n")}\n`;
}

/** Times between frames while the wheel turns, milliseconds, the shortest first. */
async function turned(page: Page): Promise<number[]> {
  const times = await page.evaluate(async (count) => {
    const sheet = document.querySelector(".sheet-box");
    const box = sheet?.getBoundingClientRect();
    if (!sheet || !box) throw new Error("there is no sheet");
    const found: number[] = [];
    let last = performance.now();
    for (let n = 0; n < count; n += 1) {
      sheet.dispatchEvent(
        new WheelEvent("wheel", {
          deltaY: n % 20 < 10 ? -12 : 12,
          clientX: box.x + box.width / 2,
          clientY: box.y + box.height / 2,
          bubbles: true,
        }),
      );
      await new Promise((done) => requestAnimationFrame(done));
      // What the canvas was told is painted before this is read.
      const canvas = document.querySelector<HTMLCanvasElement>(".sheet-canvas");
      canvas?.getContext("2d")?.getImageData(0, 0, 1, 1);
      const now = performance.now();
      found.push(now - last);
      last = now;
    }
    return found;
  }, frames);
  return times.sort((a, b) => a - b);
}

it.each([10_000, 100_000])("moves %d segments", async (segments) => {
  writeFileSync(join(workshop.parts, "waves.dxf"), waves(segments));
  const page = await workshop.page();
  const off = { toolPaths: false, starts: false };
  await page.evaluate(
    (options) => localStorage.setItem("kerf.draw.view", JSON.stringify(options)),
    off,
  );
  await page.goto(`${workshop.address}/draw`);
  await page.getByRole("button", { name: "Open…" }).click();
  const before = Date.now();
  await page.getByRole("button", { name: "waves.dxf", exact: true }).click();
  const shapes = page.locator(".facts div").filter({ hasText: "Shapes" }).locator("dd");
  await expect.poll(() => shapes.textContent(), { timeout: 60_000 }).toBe(String(segments / 100));
  const opened = Date.now() - before;
  await page.waitForTimeout(1000);
  const times = await turned(page);
  const at = (share: number) => times[Math.floor(share * (frames - 1))] ?? 0;
  const input = `${segments.toLocaleString("en")} segments`;
  const frame = (what: string, value: number): Figure => ({ input, what, value, unit: "ms" });
  figures.push(
    frame("opened and drawn", opened),
    { ...frame("frame while zooming, median", at(0.5)), goal: 12 },
    frame("frame while zooming, 19 of 20", at(0.95)),
    frame("frame while zooming, shortest", at(0)),
  );
  await page.close();
});
