import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { overlaps } from "./overlaps";
import { openWorkshop, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page({ width: 1440, height: 900 });
});
afterAll(() => workshop?.close());

it("? on a panel opens the book at its place", async () => {
  await page
    .getByRole("region", { name: "Location" })
    .getByRole("button", { name: "What is this?" })
    .click();
  await page.getByRole("heading", { name: "Frames: where is zero?" }).waitFor();
  expect(await violations(page)).toEqual([]);
  expect(await overlaps(page)).toEqual([]);
});

it("the book is searched, and its links lead to its pages", async () => {
  await page.getByLabel("Search the book").fill("touch plate");
  const found = page.locator(".book-found .text-link");
  await found.first().waitFor();
  await found.first().click();
  await page.locator(".book-text").waitFor();
  await page.getByLabel("Chapter").selectOption("console");
  await page.getByRole("img", { name: /operator's screen/ }).waitFor();
  await page.locator(".book-text .text-link", { hasText: "answer" }).first().click();
  await page.getByRole("heading", { name: "Questions without a person" }).waitFor();
  await expect.poll(() => page.getByLabel("Chapter").inputValue()).toBe("running");
});

it("the glossary tells the words of the workshop, and none of the code's", async () => {
  await page.getByRole("button", { name: "Glossary" }).click();
  await page.getByRole("cell", { name: "material left to hold a part" }).waitFor();
  expect(await page.getByText("Nouns of the code").count()).toBe(0);
  await page.getByLabel("Search the book").fill("material left to hold");
  await page.locator(".book-found .text-link", { hasText: "Words" }).first().waitFor();
  expect(await violations(page)).toEqual([]);
});

it("a job to try is opened with one press from its picture", async () => {
  await page
    .getByRole("button", { name: /^How do I/ })
    .first()
    .click();
  await page.getByRole("button", { name: /^Coaster/ }).click();
  await until(async () => (await stateOf(workshop)).opened?.name === "coaster.sbp", "it is open");
  await page.locator(".job-name", { hasText: "coaster.sbp" }).waitFor();
  await page.getByRole("link", { name: "Help" }).click();
  await page.getByLabel("Search the questions").fill("pocket");
  await expect.poll(() => page.locator(".how-cards > li").count()).toBe(1);
  // The page asks whether the file is there already.
  const others = workshop.mistakes.filter((told) => !/404 .*\/api\/files\/coaster/.test(told));
  expect(others).toEqual([]);
});
