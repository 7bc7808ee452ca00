/** A page hears its keys, STOP among them, from the first moment at which it shows anything. */

import { afterAll, beforeAll, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop();
});
afterAll(() => workshop?.close());

it("keys are heard as soon as the page is loaded, on a slow computer too", async () => {
  const page = await workshop.page();
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 10 });
  // Presses at the very moment at which the browser tells that the page is loaded.
  await page.addInitScript(() =>
    addEventListener("load", () => {
      const press = new KeyboardEvent("keydown", { key: "o", ctrlKey: true, bubbles: true });
      document.body.dispatchEvent(press);
    }),
  );
  await page.reload();
  await page.getByRole("dialog", { name: "Part folder" }).waitFor({ timeout: 20_000 });
  expect(workshop.mistakes).toEqual([]);
});
