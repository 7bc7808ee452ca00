import { afterAll, beforeAll, expect, it } from "vitest";
import { overlaps } from "./overlaps";
import { openSheet, type Sheet } from "./sheet";
import { openWorkshop, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let sheet: Sheet;

beforeAll(async () => {
  workshop = await openWorkshop();
  sheet = await openSheet(workshop);
  await sheet.page.setViewportSize({ width: 1440, height: 900 });
});
afterAll(() => workshop?.close());

/** The lower left of each shape, mm. */
const corners = async () => (await sheet.shapes()).map(({ points: [x, y] }) => [x, y]);

const key = (name: string) => sheet.page.keyboard.press(name);

it("a selected shape is dragged, nudged, copied, pasted into another drawing, and deleted by key", async () => {
  await sheet.given("rect 0,0 100,80; rect 200,0 260,40");
  await sheet.click([50, 0]);
  await expect.poll(sheet.selected).toEqual([1]);
  await sheet.drag([50, 0], [80, 30]);
  await expect.poll(async () => Math.round((await corners())[0]?.[0] ?? 0)).toBe(30);
  await expect.poll(async () => Math.round((await corners())[0]?.[1] ?? 0)).toBe(30);
  const [before = [0, 0]] = await corners();
  await key("ArrowRight");
  await expect
    .poll(async () => ((await corners())[0]?.[0] ?? 0) - (before[0] ?? 0))
    .toBeCloseTo(25.4 / 16, 2);
  await key("Control+c");
  await sheet.page.getByText("1 shape is on the clipboard.").waitFor();
  await sheet.move([150, 100]);
  await key("Control+v");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(3);
  await sheet.post({ op: "new" });
  await expect.poll(async () => (await sheet.shapes()).length).toBe(0);
  await sheet.page.getByRole("application").focus();
  await key("Control+v");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(1);
  await key("Control+a");
  await expect.poll(sheet.selected).toEqual([1]);
  await key("Delete");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(0);
});

it("shapes are a list that is walked through and acted on by keys", async () => {
  await sheet.given("rect 0,0 100,80; circle 150,40 20");
  const { page } = sheet;
  await page.getByRole("button", { name: "List 2" }).click();
  const list = page.getByRole("list", { name: "Shapes in the order of cutting" });
  await list.getByRole("button", { name: /^2: closed, black/ }).focus();
  await key("Enter");
  await expect.poll(sheet.selected).toEqual([2]);
  await key("Shift+Tab");
  await key("Delete");
  await expect.poll(async () => (await sheet.shapes()).length).toBe(1);
  expect(await violations(page)).toEqual([]);
  expect(await overlaps(page)).toEqual([]);
});

it("empty layers are folded away until they are wanted, and every operation is in sight at 900 pixels", async () => {
  await sheet.given("rect 0,0 100,80");
  const { page } = sheet;
  const layers = page.getByRole("region", { name: "Layers" });
  await expect.poll(() => layers.locator(".group-name").allTextContents()).toEqual(["black"]);
  await layers.getByRole("button", { name: "All 8" }).click();
  await expect.poll(() => layers.locator(".group-name").count()).toBe(8);
  const bottoms = await page
    .getByRole("region", { name: "Operations" })
    .getByRole("button")
    .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().bottom));
  expect(Math.max(...bottoms)).toBeLessThan(900);
});
