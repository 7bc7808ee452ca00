/** Typed and unsaved text outlives screens, reloads, tabs and servers. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { edit, text, type } from "./editing";
import { openWorkshop, until, type Workshop } from "./workshop";

let folder: string;
let workshop: Workshop;

beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), "kerf-drafts-"));
  writeFileSync(join(folder, "a.sbp"), "MX,1\n");
  writeFileSync(join(folder, "b.sbp"), "MY,1\n");
  workshop = await openWorkshop({ folder });
});
afterEach(async () => {
  await workshop?.close();
  rmSync(folder, { recursive: true, force: true });
});

const shows = (page: Page, line: string) =>
  until(async () => (await text(page)).includes(line), `the editor shows ${line}`);

const notSaved = (page: Page) => page.locator(".edit-head h1", { hasText: "not saved" }).waitFor();

/** Time of typing that may be lost when the server is killed, and a moment for the test, milliseconds. */
const keptMs = 500;

it("is there after a change of screen, a reload and in another tab", async () => {
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  await page.getByRole("link", { name: "Help" }).click();
  await page.getByRole("link", { name: "Edit" }).click();
  await shows(page, "MX,2");
  await notSaved(page);
  await type(page, "MX,3");
  // Nothing is waited for: a page that goes sends what was typed last.
  await page.reload();
  await shows(page, "MX,3");
  await page.close();
  const other = await workshop.page();
  await other.getByRole("link", { name: "Edit" }).click();
  await shows(other, "MX,3");
  expect(readFileSync(join(folder, "a.sbp"), "utf8")).toBe("MX,1\n");
});

it("is there after the server was killed, with at most half a second lost", async () => {
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  await new Promise((resolve) => setTimeout(resolve, keptMs));
  await workshop.kill();
  workshop = await openWorkshop({ folder });
  const other = await workshop.page();
  await other.getByRole("link", { name: "Edit" }).click();
  await shows(other, "MX,2");
  await notSaved(other);
});

it("keeps the drafts of two files apart", async () => {
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  await edit(page, "b.sbp");
  await shows(page, "MY,1");
  expect(await text(page)).not.toContain("MX");
  await type(page, "MY,2");
  await page.getByRole("button", { name: "a.sbp", exact: true }).click();
  await shows(page, "MX,2");
  expect(await text(page)).not.toContain("MY");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await until(
    async () => readFileSync(join(folder, "a.sbp"), "utf8") === "MX,1\nMX,2\n",
    "the one is saved",
  );
  expect(readFileSync(join(folder, "b.sbp"), "utf8")).toBe("MY,1\n");
  await page.getByRole("button", { name: "b.sbp", exact: true }).click();
  await shows(page, "MY,2");
});

it("says that the file was changed on the disk, and asks", async () => {
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  await new Promise((resolve) => setTimeout(resolve, keptMs));
  writeFileSync(join(folder, "a.sbp"), "MX,77\n");
  await page.reload();
  await page.getByText("a.sbp was changed on the disk since this text was typed").waitFor();
  await shows(page, "MX,2");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("dialog", { name: "Replace a.sbp?" }).waitFor();
  await page.getByRole("button", { name: "Cancel" }).click();
  expect(readFileSync(join(folder, "a.sbp"), "utf8")).toBe("MX,77\n");
});

it("goes when it is dropped, and then only", async () => {
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  await page.getByRole("button", { name: "Drop changes…" }).click();
  await page.getByRole("button", { name: "Cancel" }).click();
  await shows(page, "MX,2");
  await page.getByRole("button", { name: "Drop changes…" }).click();
  await page.getByRole("button", { name: "Drop changes", exact: true }).click();
  await until(async () => !(await text(page)).includes("MX,2"), "it is dropped");
  await page.reload();
  await shows(page, "MX,1");
  expect(await text(page)).not.toContain("MX,2");
});

it("loses nothing where two pages type into one file, and tells both", async () => {
  const [one, two] = [await workshop.page(), await workshop.page()];
  await edit(one, "a.sbp");
  await edit(two, "a.sbp");
  await type(one, "MX,2");
  await new Promise((resolve) => setTimeout(resolve, keptMs));
  await type(two, "MY,2");
  const told = (page: Page) =>
    page.getByText("Another page types into a.sbp too").first().waitFor();
  await told(two);
  await type(one, "MX,3");
  await told(one);
  await new Promise((resolve) => setTimeout(resolve, keptMs));
  await one.close();
  await two.close();
  const page = await workshop.page();
  await page.getByRole("link", { name: "Edit" }).click();
  await shows(page, "MX,3");
  expect(await text(page)).toBe("MX,1\nMX,2\nMX,3\n");
  const other = page.getByRole("button", { name: "a.sbp, another text" });
  await other.click();
  await shows(page, "MY,2");
  expect(await text(page)).toBe("MX,1\nMY,2\n");
  // And back: going from one to the other takes nothing away.
  await type(page, "MY,3");
  await new Promise((resolve) => setTimeout(resolve, keptMs));
  await other.click();
  await shows(page, "MX,3");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await until(
    async () => readFileSync(join(folder, "a.sbp"), "utf8") === "MX,1\nMX,2\nMX,3\n",
    "the one is saved",
  );
  await other.click();
  await shows(page, "MY,3");
});
