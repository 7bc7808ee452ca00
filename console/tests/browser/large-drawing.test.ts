/** A drawing of many shapes leaves the page usable: STOP is sent while it is on the sheet. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { circles } from "./shapes";
import { openWorkshop, script, stateOf, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop();
  writeFileSync(join(workshop.parts, "many.dxf"), circles(100_000));
});
afterAll(() => workshop?.close());

it("sends STOP with 100,000 shapes and their starts on the sheet", async () => {
  const page = await workshop.page();
  const sent: string[] = [];
  page.on("websocket", (socket) =>
    socket.on("framesent", ({ payload }) => {
      sent.push((JSON.parse(String(payload)) as { act: { do: string } }).act.do);
    }),
  );
  await page.reload();
  await page.getByRole("link", { name: "Draw" }).click();
  await script(workshop, "draw", { op: { op: "open", name: "many.dxf" } });
  expect((await stateOf(workshop)).drawing?.shapes).toBe(100_000);
  await page.getByText("many.dxf").first().waitFor();
  // The page gets the shapes, draws them, and draws them again in a while.
  for (let second = 1; second <= 8; second += 1) {
    await page.waitForTimeout(1000);
    sent.length = 0;
    await page.keyboard.press("Space");
    await expect.poll(() => sent, { timeout: 20_000 }).toContain("stop");
  }
});
