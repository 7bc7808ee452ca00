import { afterAll, beforeAll, expect, it } from "vitest";
import { openWorkshop, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({ isNew: true });
});
afterAll(() => workshop?.close());

it("a new machine leads its first visitor through its settings, until he skips that", async () => {
  const page = await workshop.page();
  const sheet = page.getByRole("dialog", { name: "Set up the machine" });
  await sheet.waitFor();
  expect(await violations(page)).toEqual([]);
  await sheet.getByRole("button", { name: "Next" }).click();
  await sheet.getByText("Step 2 of 6").waitFor();
  await sheet.getByRole("button", { name: "Skip" }).click();
  await sheet.waitFor({ state: "detached" });
  const kept = async () => {
    const value = await fetch(`${workshop.address}/api/registry/uMachineSetUp`, {
      headers: workshop.shows,
    });
    return value.ok && (await value.text()) === "done";
  };
  await until(kept, "the skip is kept");
  const other = await workshop.page();
  await other.getByRole("link", { name: "Settings" }).click();
  await other.getByRole("region", { name: "First start" }).waitFor();
  expect(await other.getByRole("dialog").count()).toBe(0);
});

it("a key is changed on the settings, kept by the browser, and no key of STOP or of another action", async () => {
  const page = await workshop.page();
  await page.getByRole("link", { name: "Settings" }).click();
  await page.locator("div", { hasText: /^Keys/ }).getByRole("button", { name: "Change…" }).click();
  const sheet = page.getByRole("dialog", { name: "Keys of actions" });
  await sheet.getByLabel("Search").fill("every action");
  const key = sheet.getByRole("button", { name: /^Key of Every action:/ });
  await key.click();
  await page.keyboard.press("Control+o");
  await sheet.getByRole("alert").filter({ hasText: "Ctrl+O means: Open a file." }).waitFor();
  await key.click();
  await page.keyboard.press("F2");
  await key.filter({ hasText: "F2" }).waitFor();
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press("Escape");
  await page.reload();
  await page.getByRole("link", { name: "Operate" }).click();
  await page.keyboard.press("F2");
  await page.getByRole("dialog", { name: "Every action" }).waitFor();
});
