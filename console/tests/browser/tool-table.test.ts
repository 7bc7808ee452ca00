/** Tools by their numbers on the page of a pretended controller: kept, asked for, measured at the sensor, forgotten. */

import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { act, arm, script, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const lines = ["G21 G90 F600", "G54", "M3 S9000", "G1 X2", "T2 M6", "G43 H2", "G0 Z0", ""];
  const shop = await driveController({ "two-tools.nc": lines.join("\n"), "zero.sbp": "ZZ\n" });
  ({ controller, workshop, page } = shop);
  await arm(page);
  await act(page, "Tools by their numbers");
  await page.getByRole("dialog", { name: "Tools by their numbers" }).waitFor();
  return shop.close;
});

const shot = async (name: string) => {
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/${name}.png` });
};

/** The tip of the tool meets the sensor at this height, mm. */
function tipAt(z: number): void {
  controller.work("nothing");
  controller.work(`plate ${z} 0 0`);
}

const tools = async () => (await stateOf(workshop)).tools;
const row = (number: number) =>
  page.getByRole("row").filter({ has: page.getByRole("rowheader", { name: `${number} ` }) });

async function add(number: string, name: string, diameter: string): Promise<void> {
  await page.getByRole("textbox", { name: "Number" }).fill(number);
  await page.getByRole("textbox", { name: "Name" }).fill(name);
  await page.getByRole("textbox", { name: "Diameter" }).fill(diameter);
  await page.getByRole("button", { name: `Keep tool ${number}` }).click();
  await row(Number(number)).waitFor();
}

it("keeps tools by their numbers, and changes one", async () => {
  await page.getByText("No tool is known yet.").waitFor();
  await add("1", "roughing", "");
  await add("2", "end mill", "3/16");
  await page.getByRole("button", { name: "Change tool 2" }).click();
  await page.getByRole("region", { name: "Change tool 2" }).getByLabel("Diameter").fill("6mm");
  await page.getByRole("button", { name: "Keep tool 2" }).click();
  await until(async () => (await tools()).tools[1]?.diameter === 6, "its diameter is kept");
  expect(await violations(page)).toEqual([]);
});

it("is told where the sensor is, and that M6 uses it", async () => {
  await page.getByRole("button", { name: "Tool 1 is in the spindle" }).click();
  const measure = page.getByRole("button", { name: "Measure tool 1" });
  await measure.waitFor();
  expect(await measure.isDisabled(), "there is no sensor yet").toBe(true);
  await page.getByRole("radio", { name: "Goes there and measures" }).click();
  await page.getByRole("button", { name: "The tool is over the sensor now" }).click();
  await page.getByText("The sensor is at 0.00, 0.00 in of the table").waitFor();
  await page.getByLabel("Input of the sensor").selectOption("1");
  await until(async () => (await tools()).hasSensor, "the sensor is set up");
  expect(await measure.isDisabled()).toBe(false);
});

it("measures the tool that is in the spindle", async () => {
  tipAt(-10);
  await page.getByRole("button", { name: "Measure tool 1" }).click();
  await row(1).getByText("measured").waitFor({ timeout: 60_000 });
  const [first] = (await tools()).tools;
  expect(first).toMatchObject({ number: 1, measured: true });
  expect(first?.length).toBeCloseTo(-10, 2);
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "it stands");
  await shot("tool-table");
});

it("asks for the next tool by its name, measures it, and Z zero goes with its length", async () => {
  expect(await script(workshop, "open", { name: "two-tools.nc" })).toBe(200);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Start", exact: true }).click();
  const asks = page.getByText("Put in tool 2 (6 mm end mill) and press OK.");
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK", exact: true }).click();
  await asks.waitFor();
  await shot("tool-asked");
  const { rpm, place } = await controller.look();
  expect(rpm, "the spindle stands").toBeNull();
  expect(place[2], "it is lifted").toBeGreaterThan(20);
  tipAt(-7);
  await page.getByRole("button", { name: "OK", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the file is over");
  expect(await tools()).toMatchObject({ inSpindle: 2 });
  const [, second] = (await tools()).tools;
  expect(second).toMatchObject({ measured: true, diameter: 6 });
  expect(second?.length).toBeCloseTo(-7, 2);
  // G43 takes nothing a second time.
  const { machine, working } = (await stateOf(workshop)).motion.at;
  expect(working[2]).toBeCloseTo(0, 3);
  expect(machine[2]).toBeCloseTo(3, 2);
});

it("moves Z zero with a length of the tool in the spindle that is corrected", async () => {
  await act(page, "Tools by their numbers");
  await page.getByRole("button", { name: "Change tool 2" }).click();
  const before = (await stateOf(workshop)).motion.at;
  const length = page.getByRole("textbox", { name: "Length" });
  expect(Number(await length.inputValue())).toBeCloseTo(-7 / 25.4, 3);
  await length.fill(String(-6.5 / 25.4));
  await page.getByRole("button", { name: "Keep tool 2" }).click();
  await until(async () => {
    const { working } = (await stateOf(workshop)).motion.at;
    return Math.abs((working[2] ?? 0) - ((before.working[2] ?? 0) - 0.5)) < 0.01;
  }, "the tool stands 0.5 mm lower above the work");
  const { motion, messages } = await stateOf(workshop);
  expect(motion.at.machine).toEqual(before.machine);
  expect(messages.at(-1)?.text).toMatch(/^Z zero goes up by 0\.5\d* mm with the length/);
});

it("leaves Z zero where it was set with the very tool", async () => {
  await page.keyboard.press("Escape");
  expect(await script(workshop, "open", { name: "zero.sbp" })).toBe(200);
  await page.getByText("zero.sbp").first().waitFor();
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => {
    const { machine, motion } = await stateOf(workshop);
    return machine.state === "idle" && Math.abs(motion.at.working[2] ?? 1) < 1e-6;
  }, "it is zeroed");
  await act(page, "Tools by their numbers");
  // Nothing finds the place again at which it was measured.
  await page.getByText("This machine finds no home").waitFor();
  await page.getByRole("button", { name: "Change tool 2" }).click();
  await page.getByRole("textbox", { name: "Length" }).fill("-0.2");
  await page.getByRole("button", { name: "Keep tool 2" }).click();
  await until(async () => {
    const { messages } = await stateOf(workshop);
    return messages.some(({ text }) => text.startsWith("Z zero stays"));
  }, "that is told");
  expect((await stateOf(workshop)).motion.at.working[2]).toBeCloseTo(0, 6);
  await page.keyboard.press("Escape");
});

it("forgets one", async () => {
  await act(page, "Tools by their numbers");
  await page.getByRole("button", { name: "Forget tool 1" }).click();
  await until(async () => (await tools()).tools.length === 1, "it is forgotten");
});
