import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { SettingArea } from "../../src/wire/messages";
import { overlaps } from "./overlaps";
import { openWorkshop, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page({ width: 1440, height: 900 });
  await page.getByRole("link", { name: "Settings" }).click();
});
afterAll(() => workshop?.close());

const setting = async (key: string) => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  return areas.flatMap((area) => area.settings).find((entry) => entry.key === key)?.value;
};
const search = (words: string) => page.getByLabel("Search settings").fill(words);

it("axes stand side by side, a changed value is marked, and one press takes the usual one", async () => {
  await page.getByLabel("Topic").selectOption("Speeds");
  const speeds = page.getByRole("region", { name: "Speeds", exact: true });
  const heads = await speeds.locator("th[scope=col]").allTextContents();
  expect(heads).toEqual(["XY", "Z", "A", "B", "C"]);
  const entry = speeds.getByLabel("Cut, Z", { exact: true });
  await entry.fill("2");
  await entry.press("Enter");
  await expect.poll(() => setting("speeds.cut.z")).toBe("50.8");
  await expect.poll(() => speeds.locator(".setting-changed").count()).toBe(1);
  await speeds.getByRole("button", { name: "Usual: Cut" }).click();
  await expect.poll(() => setting("speeds.cut.z")).toBe("25.4");
  await expect.poll(() => speeds.locator(".setting-changed").count()).toBe(0);
});

it("settings are found by the words of a shop", async () => {
  await search("inch");
  await page.locator('[data-key="units"]').waitFor();
  await search("soft limits");
  await page.getByLabel("High, X").waitFor();
  await search("probe");
  await page.getByRole("button", { name: "Zero Z with a touch plate (C2)" }).waitFor();
  await search("backup");
  await page.getByText("Save and load all settings").waitFor();
  expect(await overlaps(page)).toEqual([]);
  await search("");
});

it("settings are saved as a file, loaded again, and each change can be taken back", async () => {
  await search("cutter diameter");
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save settings" }).click();
  const kept = join(workshop.parts, "saved.txt");
  await (await saved).saveAs(kept);
  const text = readFileSync(kept, "utf8");
  expect(text).toContain("cutter.diameter_mm = 6.35\n");
  const load = (content: string) =>
    page.locator("input[type=file]").setInputFiles({
      name: "machine-settings.txt",
      mimeType: "text/plain",
      buffer: Buffer.from(content),
    });
  await load(text.replace("cutter.diameter_mm = 6.35", "cutter.diameter_mm = 12.7\nno.such = 1"));
  const sheet = page.getByRole("dialog", { name: "Load settings?" });
  await sheet.getByText("no.such = 1").waitFor();
  expect(await violations(page)).toEqual([]);
  await sheet.getByRole("button", { name: "Change 1 setting" }).click();
  await expect.poll(() => setting("cutter.diameter_mm")).toBe("12.7");
  const changes = page.getByRole("region", { name: "Changes of settings" });
  await changes.getByText("by this machine").first().waitFor();
  await page.getByRole("button", { name: "Take back: Cutter, diameter, 6.35" }).click();
  await expect.poll(() => setting("cutter.diameter_mm")).toBe("6.35");
  // The page is behind a change: the file is compared with the settings as they are.
  await changes.getByText("12.7 → 6.35").first().waitFor();
  await page.route("**/api/settings", async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 2000));
    await route.continue().catch(() => undefined);
  });
  await load(text.replace("cutter.diameter_mm = 6.35", "cutter.diameter_mm = 12.7"));
  await sheet.getByRole("button", { name: "Change 1 setting" }).click();
  await expect.poll(() => setting("cutter.diameter_mm")).toBe("12.7");
  await load(text);
  await sheet.getByRole("button", { name: "Change 1 setting" }).click();
  await expect.poll(() => setting("cutter.diameter_mm")).toBe("6.35");
  // Nor does a file that is saved hang on what has come to the page so far.
  await page.reload();
  const early = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save settings" }).click();
  await (await early).saveAs(kept);
  expect(readFileSync(kept, "utf8")).toContain("cutter.diameter_mm = 6.35");
  await page.unroute("**/api/settings");
});

it("a new machine is set up step by step", async () => {
  await page.getByRole("button", { name: "Set up…" }).click();
  const sheet = page.getByRole("dialog", { name: "Set up the machine" });
  await sheet.getByRole("radio", { name: "mm" }).click();
  await expect.poll(() => setting("units")).toBe("mm");
  const next = () => sheet.getByRole("button", { name: "Next" }).click();
  await next();
  await next();
  await sheet.getByLabel("Size in X").fill("800");
  await sheet.getByLabel("Size in X").press("Enter");
  await expect.poll(() => setting("view.table_mm")).toMatch(/^\[?800, /);
  await expect.poll(() => setting("limits.high")).toMatch(/^\[?800, /);
  await next();
  await sheet.getByRole("radio", { name: "yes" }).click();
  await expect.poll(() => setting("limits.check")).toBe("true");
  await next();
  await next();
  await sheet.getByLabel("Inputs, 4").waitFor();
  expect(await violations(page)).toEqual([]);
  expect(await overlaps(page)).toEqual([]);
  await sheet.getByRole("button", { name: "Done" }).click();
});
