/** Settings of the display that the page follows (VD), variables (UL), nudges (MN). */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  location,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 10 });
  const long = "SA\nMS,1,1\nMZ,-.1\nM2,4,0\nM2,4,3\nM2,0,3\nM2,0,0\nJZ,.5\nEND\n";
  writeFileSync(join(workshop.parts, "long.sbp"), long);
  writeFileSync(join(workshop.parts, "hello.sbp"), 'PRINT "Hello"\nEND\n');
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  await page.getByLabel("Command line").fill("");
});

const state = (wanted: string) =>
  until(async () => (await stateOf(workshop)).machine.state === wanted, wanted);
const run = (line: string) => carryOut(workshop, page, line);
const keypad = () => page.getByRole("dialog", { name: "Keypad" });
/** The keypad is, on the page and at the machine. */
const closed = async () => {
  await state("idle");
  await keypad().waitFor({ state: "detached" });
};
const working = async (n: number) => (await stateOf(workshop)).motion.at.working[n] ?? 0;
const settings = async () => {
  const values = await (await fetch(`${workshop.address}/api/values`)).json();
  return (values as { settings: string[] }).settings;
};

it("sbp_val_vd_fixed: a tap at the keypad moves the distance of VD", async () => {
  await run("VD,,,,,,,,.05");
  const before = await working(0);
  await page.getByLabel("Command line").press("k");
  await keypad().waitFor();
  await page.keyboard.press("d");
  await expect.poll(() => keypad().getByLabel("Distance").inputValue()).toBe("0.05");
  await page.keyboard.press("ArrowRight", { delay: 500 });
  await state("asking");
  await expect.poll(() => working(0)).toBeCloseTo(before + 0.05 * 25.4, 3);
  await page.keyboard.press("Escape");
  await closed();
});

it("sbp_val_vd_autooff: with it on, closing the keypad switches outputs off", async () => {
  const output = async () => (await stateOf(workshop)).io.outputs[2]?.on;
  await run("SO,3,1");
  for (const [auto, left] of [
    [0, true],
    [1, false],
  ] as const) {
    await run(`VD,,,,,,,,,,,,,,,,${auto}`);
    await page.getByLabel("Command line").press("k");
    await keypad().waitFor();
    expect(await output()).toBe(true);
    await page.keyboard.press("Escape");
    await closed();
    await expect.poll(output).toBe(left);
  }
  await run("VD,,,,,,,,,,,,,,,,0");
});

it("sbp_val_vd_progress: the path done so far, in FULL only; a right click leads to its settings", async () => {
  const picture = page.getByRole("img", { name: /pieces of the path are cut/ });
  const done = async () => Number.parseInt((await picture.getAttribute("aria-label")) ?? "", 10);
  expect(await picture.count()).toBe(0);
  await run("VD,,,,,,,,,,,,,,,,,1");
  await picture.waitFor();
  await script(workshop, "open", { name: "long.sbp" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await expect.poll(done).toBe(0);
  await page.getByRole("button", { name: "Start" }).click();
  await expect.poll(done).toBeGreaterThan(1);
  await state("idle");
  await page.getByRole("radio", { name: "EASY" }).click();
  await picture.waitFor({ state: "detached" });
  await page.getByRole("radio", { name: "FULL" }).click();
  await picture.click({ button: "right" });
  await page.getByRole("dialog", { name: /^VD/ }).waitFor();
  await page.keyboard.press("Escape");
  await run("VD,,,,,,,,,,,,,,,,,0");
});

it("sbp_io_print_window_pos: the window stands where VD says, and VD knows where it was moved", async () => {
  await run("VD,,,,,,,,,,,,1005,1995,6000,4005");
  await run("FP,hello.sbp");
  const panel = page.getByRole("region", { name: "Message screen" });
  await panel.waitFor();
  const top = (await page.locator(".body").boundingBox())?.y ?? 0;
  expect(await panel.boundingBox()).toEqual({ x: 67, y: top + 133, width: 400, height: 267 });
  await page.mouse.move(150, top + 145);
  await page.mouse.down();
  await page.mouse.move(190, top + 165, { steps: 4 });
  await page.mouse.up();
  await expect
    .poll(async () =>
      (await settings())
        .find((line) => line.startsWith("VD,"))
        ?.split(",")
        .slice(12, 16),
    )
    .toEqual(["1605", "2295", "6000", "4005"]);
  await page.getByRole("button", { name: "Close the message screen" }).click();
  await page.getByLabel("Command line").fill("VD");
  await page.getByRole("button", { name: "Fill-in sheet" }).click();
  const sheet = page.getByRole("dialog", { name: /^VD/ });
  await sheet.waitFor();
  const shown = await sheet
    .getByRole("textbox")
    .evaluateAll((fields) => fields.map((field) => (field as HTMLInputElement).value));
  for (const value of ["1605", "2295", "6000", "4005"]) expect(shown).toContain(value);
  await page.keyboard.press("Escape");
});

it("sbp_out_display: twelve lights of outputs; in FULL a click switches, 1 and 2 ask first", async () => {
  const lights = page.locator(".lamp-output");
  expect(await lights.count()).toBe(12);
  const on = async (n: number) => (await stateOf(workshop)).io.outputs[n - 1]?.on;
  const light = (n: number) => page.getByRole("button", { name: new RegExp(`^Output ${n} `) });
  await light(5).click();
  await expect.poll(() => on(5)).toBe(true);
  await expect.poll(() => light(5).getAttribute("aria-pressed")).toBe("true");
  await state("idle");
  await page.locator(".state", { hasText: "Ready" }).waitFor();
  await light(5).click();
  await expect.poll(() => on(5)).toBe(false);
  await state("idle");
  for (const n of [1, 2]) {
    await page.locator(".state", { hasText: "Ready" }).waitFor();
    await light(n).click();
    const sheet = page.getByRole("dialog", { name: `Switch output ${n}?` });
    await sheet.getByRole("button", { name: "Cancel" }).click();
    expect(await on(n)).toBe(false);
    await light(n).click();
    await sheet.getByRole("button", { name: `Switch output ${n}` }).click();
    // The spindle asks as it does for a typed line.
    const ready = page.getByRole("button", { name: "OK", exact: true });
    if (n === 1) await ready.click();
    await expect.poll(() => on(n)).toBe(true);
    await state("idle");
  }
  await run("SO,1,0");
  await run("SO,2,0");
  await page.getByRole("radio", { name: "EASY" }).click();
  expect(await page.getByRole("button", { name: /^Output 5/ }).count()).toBe(0);
  expect(await lights.count()).toBe(12);
  await page.getByRole("radio", { name: "FULL" }).click();
});

it("sbp_lim_indicators: inputs are green by state, their numbers yellow or red by what they are for", async () => {
  await run("VN,,,,,1,2");
  const light = (n: number) => page.locator(".lamp-input").nth(n - 1);
  const colour = (n: number, part: string, of: "backgroundColor" | "color") =>
    light(n)
      .locator(part)
      .evaluate((one, name) => getComputedStyle(one)[name as "color"], of);
  const rgb = (text: string) => (text.match(/\d+/g) ?? []).map(Number);
  const back = async (n: number) =>
    rgb(await light(n).evaluate((one) => getComputedStyle(one).backgroundColor));
  const { io } = await stateOf(workshop);
  const of = (duty: string) => io.inputs.find((input) => input.duty === duty)?.number ?? 0;
  const number = async (duty: string) => rgb(await colour(of(duty), ".lamp-number", "color"));
  const [standard, limit, stop] = [
    await number("standard"),
    await number("limit"),
    await number("stop"),
  ];
  const [r = 0, g = 0, b = 0] = limit;
  expect(r > 230 && g > 200 && b < 120, "bright yellow").toBe(true);
  expect((standard[0] ?? 0) < r - 40 && (standard[2] ?? 0) < 120, "dim yellow").toBe(true);
  expect((stop[0] ?? 0) > 230 && (stop[1] ?? 0) < 130, "bright red").toBe(true);
  const dark = await back(7);
  const { lease } = await stateOf(workshop);
  expect(lease).not.toBeNull();
  await page.getByRole("button", { name: "In", exact: true }).click();
  await page.getByRole("switch", { name: "Input 7" }).click();
  await until(async () => (await stateOf(workshop)).io.inputs[6]?.on === true, "input 7 is on");
  await expect.poll(async () => (await back(7))[1]).toBeGreaterThan(200);
  expect((dark[1] ?? 255) < 100 && (dark[1] ?? 0) > (dark[0] ?? 255), "dark green").toBe(true);
  await page.getByRole("switch", { name: "Input 7" }).click();
  await page.keyboard.press("Escape");
  await state("idle");
  await run("VN,,,,,0,0");
});

it("sbp_cmd_ul: the list of variables is changed and added to, and both take effect", async () => {
  await run("&A = 2");
  await command(page, "UL");
  const sheet = page.getByRole("dialog", { name: "Values" });
  await sheet.getByRole("button", { name: "Change or add…" }).click();
  const lines = sheet.getByRole("textbox", { name: "Variables, a line each" });
  expect(await lines.inputValue()).toContain("&A = 2");
  await lines.fill("&A = 3\n&B = 4");
  await sheet.getByRole("button", { name: "Save" }).click();
  await sheet.getByRole("row", { name: /&B 4/ }).waitFor();
  await sheet.getByRole("row", { name: /&A 3/ }).waitFor();
  await page.keyboard.press("Escape");
  await state("idle");
  await run("SA");
  await run("M2,&A,&B");
  expect([await location(page, "X"), await location(page, "Y")]).toEqual([3, 4]);
});

it("sbp_cmd_mn: the panel nudges by a distance that is set; the working place stays, base moves", async () => {
  await run("M2,1,1");
  await command(page, "MN");
  const sheet = page.getByRole("dialog", { name: "Nudge" });
  const field = sheet.getByLabel("Distance");
  expect(await field.inputValue()).toBe("0.01");
  const before = (await stateOf(workshop)).motion.at;
  const nudged = async (mm: number) => {
    await expect
      .poll(async () => (await stateOf(workshop)).motion.at.base[0])
      .toBeCloseTo(before.base[0] + mm, 6);
    // The tool moves; when it stands the zero has come along.
    await expect.poll(() => working(0)).toBeCloseTo(before.working[0], 9);
  };
  await sheet.getByRole("button", { name: "X +" }).click();
  await nudged(0.254);
  await state("idle");
  await field.fill("0.05");
  await sheet.getByRole("button", { name: "X −" }).click();
  await nudged(0.254 - 1.27);
  await page.keyboard.press("Escape");
  const { lease } = await stateOf(workshop);
  // A script that does not drive is refused; the one that drives does the same as the panel.
  expect(
    await script(workshop, "nudge", { lease: lease?.number, axis: "X", distance: 0.254 }),
  ).toBe(403);
});
