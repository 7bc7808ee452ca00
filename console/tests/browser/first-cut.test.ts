import { afterAll, beforeAll, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({
    parts: ["01-first-cut/first-cut.sbp"],
    open: "first-cut.sbp",
    rate: 20,
  });
});
afterAll(() => workshop?.close());

it("makes the first cut in two clicks", async () => {
  const page = await workshop.page();
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK" }).click();
  await page.getByText("finished").waitFor();
  expect(await page.locator('[data-axis="X"]').textContent()).toBe("0.000");
  expect(workshop.mistakes).toEqual([]);
});
