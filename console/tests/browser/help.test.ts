/** The pages of the help, by the letters of their commands. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page();
  await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
});
afterAll(() => workshop?.close());

/** Types the letters and gives what the page says. */
async function typed(letters: string): Promise<string> {
  await page.goto(workshop.address);
  await page.getByLabel("Command line").pressSequentially(letters);
  await page.getByRole("heading", { level: 1, name: "Help" }).waitFor();
  return (await page.locator(".help-page").textContent()) ?? "";
}

it("sbp_cmd_ha: version, driver and licence", async () => {
  const words = await typed("ha");
  for (const word of ["Kerf 0.", "simulated", "MIT", "Apache-2.0"]) expect(words).toContain(word);
});

it("sbp_cmd_hb: bulletins are links that open on a click only", async () => {
  await typed("hb");
  const links = page.locator(".help-page a");
  expect(await links.count()).toBe(2);
  expect(await links.first().getAttribute("target")).toBe("_blank");
  expect(page.url()).toContain("/help");
});

it("sbp_cmd_hc: the command reference, to be searched", async () => {
  expect(await typed("hc")).toContain("Cut Circle");
  await page.getByLabel("Look for").fill("keypad");
  expect(await page.locator(".help-page").textContent()).not.toContain("Cut Circle");
});

it("sbp_cmd_he: parameters in the order of part files, in columns", async () => {
  await typed("he");
  const row = page.locator(".help-page tr", { has: page.getByRole("rowheader", { name: "CC" }) });
  expect(await row.locator("td").allTextContents()).toEqual(
    expect.arrayContaining(["Diameter*", "Plunge", "Feature"]),
  );
});

it("sbp_cmd_hn: a request for help with the problem log, for the person to send", async () => {
  expect(await typed("hn")).toContain("Problem log");
  const saved = page.getByRole("link", { name: "Save problem.log" });
  expect(await saved.getAttribute("download")).toBe("problem.log");
});

it("sbp_cmd_hq: the first steps", async () => {
  expect(await typed("hq")).toContain("Arm the machine");
});

it("sbp_cmd_hr: every command on a page that can be printed", async () => {
  const words = await typed("hr");
  for (const letters of ["MX", "CC", "ZZ", "VD"]) expect(words).toContain(letters);
  await page.getByRole("button", { name: "Print" }).waitFor();
});

it("sbp_cmd_ht: troubles and what helps, the link among them", async () => {
  expect(await typed("ht")).toContain("No link to the machine");
});

it("sbp_cmd_hu: the guide through the screens", async () => {
  const words = await typed("hu");
  for (const title of ["Operate", "Edit", "Draw", "Settings"]) expect(words).toContain(title);
});

it("sbp_cmd_hw: a link to the project's home", async () => {
  await typed("hw");
  expect(await page.locator(".help-page a").getAttribute("href")).toMatch(/^https:/);
});
