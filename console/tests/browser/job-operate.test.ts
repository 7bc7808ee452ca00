/** A job is another kind of file: opened by the same picker, shown in the same place, started by the same Start. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { RunRecord } from "../../src/wire/messages";
import { openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 2, parts: ["01-first-cut/first-cut.sbp"] });
  const draw = (op: object) => script(workshop, "draw", { op });
  expect(await draw({ op: "new" })).toBe(200);
  expect(await draw({ op: "do", clauses: "line 0,0 100,0; line 0,40 100,40" })).toBe(200);
  expect(await draw({ op: "save", name: "part.rsg" })).toBe(200);
  expect(await script(workshop, "machine", { drawing: "part.rsg", anew: false })).toBe(200);
  expect(await script(workshop, "close")).toBe(200);
  page = await workshop.page({ width: 1440, height: 900 });
});
afterAll(() => workshop?.close());

const choose = async (name: RegExp) => {
  await page.keyboard.press("Control+o");
  await page.getByRole("option", { name }).click();
};

it("a job from the picker to its cut, in three presses, on the screen where a program is", async () => {
  await choose(/part\.rsm/);
  await page.getByLabel("Paths of the job").waitFor();
  expect(new URL(page.url()).pathname).toBe("/");
  await page.locator(".job-status", { hasText: "ready" }).waitFor();
  await page.locator(".path-row").nth(1).waitFor();
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.locator(".path-running").first().waitFor();
  await until(isOver, "it is cut");
  await page.locator(".job-status", { hasText: "finished" }).waitFor();
  const asked = await fetch(`${workshop.address}/api/history`, { headers: workshop.shows });
  const [last] = (await asked.json()) as RunRecord[];
  expect([last?.file, last?.ended]).toEqual(["part.rsm", "ok"]);
});

const isOver = async () => {
  const { job, machine } = await stateOf(workshop);
  return job?.ended === "ok" && machine.state === "idle";
};

it.each(["light", "dark", "contrast"])(
  "nothing is found for those who see less, %s",
  async (theme) => {
    await page.evaluate((name) => document.documentElement.setAttribute("data-theme", name), theme);
    expect(await violations(page)).toEqual([]);
  },
);

it("a program opened after it stands in the same place", async () => {
  await choose(/first-cut\.sbp/);
  await page.getByLabel(/^Lines of first-cut/).waitFor();
  expect(await page.getByLabel("Paths of the job").count()).toBe(0);
});

it("the address that jobs had leads to it, and F10 starts the job that is open", async () => {
  await choose(/part\.rsm/);
  await page.goto(`${workshop.address}/job`);
  await page.getByLabel("Paths of the job").waitFor();
  await page.locator(".job-status", { hasText: "finished at" }).waitFor();
  await page.keyboard.press("F10");
  await page.locator(".path-running").first().waitFor();
  await until(isOver, "it is cut");
});

it("a drawing that is opened to be run says that it has no tool path", async () => {
  expect(await script(workshop, "open", { name: "part.rsg" })).toBe(200);
  await page.getByText("is a drawing: it has no tool path yet").waitFor();
  expect(workshop.mistakes).toEqual([]);
});
