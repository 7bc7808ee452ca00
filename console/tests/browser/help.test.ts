/** The pages of the help, by the letters of their commands. */

import type { Page, Route } from "playwright-core";
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
  await page.locator(".state", { hasText: /Disarmed|Ready/ }).waitFor();
  await page.getByLabel("Command line").pressSequentially(letters);
  await page.getByRole("heading", { level: 1, name: "Help" }).waitFor();
  await page.locator(".help-page", { hasNotText: "Reading…" }).waitFor();
  return (await page.locator(".help-page").textContent()) ?? "";
}

it("sbp_cmd_ha: version, driver and licence", async () => {
  const words = await typed("ha");
  for (const word of ["Kerf 0.", "simulated", "MIT", "Apache-2.0"]) expect(words).toContain(word);
});

/** Follows the links of a page of the help: the status that this Kerf answers to each. */
async function answers(): Promise<number[]> {
  const links = await page.locator(".help-page a").all();
  const addresses = await Promise.all(links.map((link) => link.getAttribute("href")));
  const asked = addresses.map((href) => fetch(new URL(href ?? "", workshop.address)));
  return (await Promise.all(asked)).map(({ status }) => status);
}

it("sbp_cmd_hb: bulletins tell the news, and their link opens on a click only, and leads somewhere", async () => {
  await typed("hb");
  const news = page.getByRole("region", { name: "News" });
  await news.getByText("The first version: part files, G-code and drawings").waitFor();
  await news.getByRole("heading", { name: /^0\.1\.0/ }).waitFor();
  const links = page.locator(".help-page a");
  expect(await links.first().getAttribute("target")).toBe("_blank");
  expect(await answers()).toEqual([200]);
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

it("letters that are typed before the table of commands has come are done when it comes", async () => {
  const late = async (route: Route) => {
    await new Promise((passed) => setTimeout(passed, 1500));
    await route.continue();
  };
  await page.route("**/api/commands", late);
  expect(await typed("ha")).toContain("Kerf 0.");
  await page.unroute("**/api/commands", late);
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

it("sbp_cmd_hw: what this Kerf serves, each link leads somewhere", async () => {
  await typed("hw");
  expect(await answers()).toEqual([200, 200, 200]);
});
