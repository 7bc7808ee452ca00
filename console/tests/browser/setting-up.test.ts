/** Surfacing and true steps on the page of the simulated machine. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { act, arm, openWorkshop, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page();
  await arm(page);
});
afterAll(() => workshop?.close());

const shot = async (name: string) => {
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/${name}.png` });
};

const close = () => page.getByRole("button", { name: "Close", exact: true }).click();

it("makes a program that planes an area, and draws it before it starts", async () => {
  await act(page, "Surfacing: plane a board");
  await page.getByRole("dialog", { name: "Surfacing" }).waitFor();
  const fields = { "Area, X": "10", "Area, Y": "6", "Bit diameter": "2" };
  for (const [name, text] of Object.entries(fields)) await page.getByLabel(name).fill(text);
  await page.getByLabel("Pattern").selectOption("rows along Y");
  expect(await page.getByRole("button", { name: "Start surfacing" }).count()).toBe(0);
  await page.getByRole("button", { name: "Make the program" }).click();
  await page.getByRole("button", { name: "Start surfacing" }).waitFor();
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === "surface.sbp" && opened.preview.state === "ready";
  }, "it is drawn");
  expect(await violations(page)).toEqual([]);
  await shot("surfacing");
  await close();
});

const stepsOfX = async () => {
  const answer = await page.request.get(`${workshop.address}/api/settings`);
  const areas = (await answer.json()) as { settings: { key: string; value: string }[] }[];
  const found = areas.flatMap(({ settings }) => settings).find((it) => it.key === "steps.per_unit");
  return Number(found?.value.replace("[", "").split(",")[0]);
};

it("moves a way, and writes the steps that make it true after a question", async () => {
  await act(page, "Steps per millimetre");
  const before = await stepsOfX();
  await page.getByLabel("Way to move").fill("4");
  await page.getByRole("button", { name: "Move X so far" }).click();
  await until(async () => {
    const { machine, motion } = await stateOf(workshop);
    return machine.state === "idle" && Math.abs((motion.at.machine[0] ?? 0) - 101.6) < 0.01;
  }, "it has moved");
  await page.getByLabel("Way that was measured").fill("3.96");
  await page.getByRole("button", { name: "Write the steps…" }).click();
  expect(await stepsOfX()).toBe(before);
  await shot("tuning");
  await page.getByRole("button", { name: "Write", exact: true }).click();
  await until(async () => (await stepsOfX()) !== before, "it is written");
  expect((await stepsOfX()) / before).toBeCloseTo(4 / 3.96, 6);
  expect(await violations(page)).toEqual([]);
});
