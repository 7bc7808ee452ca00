import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, openWorkshop, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({
    parts: ["01-first-cut/first-cut.sbp"],
    open: "first-cut.sbp",
  });
  page = await workshop.page();
});
afterAll(() => workshop?.close());

/** Screens on which a person may be when something goes wrong. */
const places: Record<string, () => Promise<void>> = {
  operator: () => page.getByRole("link", { name: "Operate" }).click(),
  editor: () => page.getByRole("link", { name: "Edit" }).click(),
  settings: () => page.getByRole("link", { name: "Settings" }).click(),
  help: () => page.getByRole("link", { name: "Help" }).click(),
  files: async () => {
    await page.getByRole("link", { name: "Operate" }).click();
    await page.keyboard.press("Control+o");
  },
  palette: async () => {
    await page.getByRole("link", { name: "Operate" }).click();
    await page.keyboard.press("Control+k");
  },
};

it("sbp_con_stop: STOP is in its place and works from every screen and dialog", async () => {
  await arm(page);
  const stop = page.getByRole("button", { name: "STOP", exact: true });
  const place = await stop.boundingBox();
  for (const [name, go] of Object.entries(places)) {
    await page.getByRole("link", { name: "Operate" }).click();
    await page.getByRole("button", { name: "Start" }).click();
    await page.getByText("The spindle is about to start.").waitFor();
    await page.getByRole("button", { name: "OK" }).click();
    await page.locator(".state", { hasText: "Running" }).waitFor();
    await go();
    expect(await stop.boundingBox(), name).toEqual(place);
    await stop.click();
    // In the middle of a move it asks whether to go on; a wait is over at once.
    const quit = page.getByRole("button", { name: "Quit" });
    await until(async () => {
      // Gone by itself it was pressed already.
      if ((await quit.count()) > 0) await quit.click({ timeout: 1000 }).catch(() => undefined);
      return (await page.locator(".state strong").textContent()) === "Ready";
    }, `${name}: stopped`);
    await page.keyboard.press("Escape");
  }
});
