/** Rows of the ledger about what the page of a job tells and takes before its start, and at it. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { SettingArea } from "../../src/wire/messages";
import { act, arm, openWorkshop, script, stands, stateOf, until, type Workshop } from "./workshop";

const shots = process.env.KERF_SHOTS;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 10, machine: "sim" });
  page = await workshop.page({ width: 1360, height: 900 });
});
afterAll(() => workshop?.close());

const draw = async (op: object) => expect(await script(workshop, "draw", { op })).toBe(200);
/** Draws something, machines it, and shows its job. */
async function machined(name: string, clauses: string) {
  await draw({ op: "new" });
  await draw({ op: "do", clauses });
  await draw({ op: "save", name });
  expect(await script(workshop, "machine", { drawing: name })).toBe(200);
  await show("Operate");
  await previewed();
}
const show = (screen: string) => page.getByRole("link", { name: screen, exact: true }).click();
const previewed = () =>
  until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
const rests = () => until(() => stands(workshop), "the machine is at rest");
const setting = async (key: string) => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  return areas.flatMap(({ settings }) => settings).find((entry) => entry.key === key)?.value;
};
/** The setting of this key on the page of settings. */
async function onPage(key: string) {
  await show("Settings");
  await page.getByLabel("Search settings").fill(key);
  const row = page.locator(".setting");
  await expect.poll(() => row.count()).toBe(1);
  return row;
}
/** Enters a number in a field of the job. */
async function enter(label: string, value: string) {
  const field = page.getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press("Enter");
}
const start = () =>
  page.getByRole("region", { name: "Job" }).getByRole("button", { name: "Start" }).click();
const finished = async () => {
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is cut");
  await rests();
};
const consoleShows = (words: string) =>
  expect.poll(() => page.locator(".hand-console-screen").textContent()).toContain(words);

it("pro_homing_first: what is not homed is told beside the origin, until its switch was found", async () => {
  await machined("line.rsg", "line 0,0 500,0");
  const warning = page.locator(".cut-warning");
  const told = (axes: string) =>
    expect
      .poll(() => warning.textContent())
      .toContain(`Not homed: ${axes}. The origin and the bounds`);
  const homed = async () => (await stateOf(workshop)).setup.homed;
  await told("X, Y, Z");
  expect(await homed()).toBe("");
  if (shots) await page.screenshot({ path: `${shots}/not-homed.png` });
  await arm(page);
  await act(page, "Hand console");
  const presses = async (...keys: string[]) => {
    for (const key of keys) await page.keyboard.press(key);
  };
  await consoleShows("JOB: line");
  await presses("F12", "Numpad5", "Numpad0", "NumpadEnter");
  await told("X, Y");
  await rests();
  await presses("F12", "Numpad5", "Numpad1", "NumpadEnter");
  await warning.waitFor({ state: "detached" });
  await rests();
  expect(await homed()).toBe("XYZ");
});

it("pro_job_step_z: the heights are on the page of the job, are set there, and by the tool", async () => {
  const shown = async () => {
    const fields = ["Z top", "Z surface", "Z bottom"].map((label) =>
      page.getByLabel(label, { exact: true }).inputValue(),
    );
    return (await Promise.all(fields)).map((text) => Math.round(Number(text) * 10) / 10);
  };
  const kept = async () =>
    Promise.all(
      ["top", "surface", "bottom"].map(async (z) => Number(await setting(`zpos.${z}_mm`))),
    );
  expect(await shown()).toEqual([-10, -20, -30]);
  await enter("Z bottom", "-28");
  await expect.poll(shown).toEqual([-10, -20, -28]);
  await expect.poll(async () => (await kept())[2]).toBeCloseTo(-28, 3);
  // Z settings: the tool goes to each height, and Enter records where it stands.
  const at = (z: number) =>
    until(async () => {
      const { motion } = await stateOf(workshop);
      return Math.abs((motion.at.machine[2] ?? 0) - z) < 0.01 && (await stands(workshop));
    }, `the tool is at ${z}`);
  for (const key of ["F12", "Numpad2", "NumpadEnter"]) await page.keyboard.press(key);
  for (const [words, z] of [
    ["ZTop", -10],
    ["ZSurface", -20],
    ["ZBottom", -28],
  ] as const) {
    await consoleShows(words);
    await at(z);
    if (words === "ZTop") {
      await page.keyboard.down("Numpad5");
      await until(
        async () => ((await stateOf(workshop)).motion.at.machine[2] ?? 0) > z + 0.5,
        "up",
      );
      await page.keyboard.up("Numpad5");
      await rests();
    }
    await page.keyboard.press("NumpadEnter");
  }
  await until(async () => ((await kept())[0] ?? -10) > -9.5, "all three are recorded");
  const [top = 0, surface, bottom] = await kept();
  expect([surface, bottom].map((z) => Math.round(z ?? 0))).toEqual([-20, -28]);
  await expect.poll(shown).toEqual([Math.round(top * 10) / 10 + 0, -20, -28]);
});

it("pro_job_step_speeds: speeds that are entered hold at the next start, which shows them", async () => {
  await page.getByRole("complementary", { name: "Hand console" }).waitFor();
  await enter("Cutting speed", "3000");
  await expect
    .poll(async () => Number(await setting("smoothing.cut_speed_mm_s")))
    .toBeCloseTo(50, 2);
  await enter("Plunging speed", "600");
  await expect.poll(async () => Number(await setting("plunge.speed_mm_s"))).toBeCloseTo(10, 2);
  await previewed();
  const before = (await stateOf(workshop)).job?.run;
  await start();
  const speeds: number[] = [];
  const downs: number[] = [];
  let last: readonly number[] = [];
  await until(async () => {
    const { motion, job } = await stateOf(workshop);
    const [x, y, z] = [0, 1, 2].map((axis) => motion.at.machine[axis] ?? 0) as [
      number,
      number,
      number,
    ];
    const plunges = x === last[0] && y === last[1] && z < (last[2] ?? z) - 1e-3;
    if (motion.line === 1 && motion.cutting) (plunges ? downs : speeds).push(motion.speedMmS);
    last = [x, y, z];
    return speeds.length > 4 || (job?.run !== before && job?.ended === "ok");
  }, "it cuts");
  const inForce = async () =>
    Promise.all(
      ["Cutting speed", "Plunging speed"].map(async (label) =>
        Number(await page.getByLabel(label, { exact: true }).inputValue()),
      ),
    );
  expect(await inForce()).toEqual([3000, 600]);
  expect(await page.getByLabel("Cutting speed", { exact: true }).isDisabled()).toBe(true);
  await finished();
  expect(Math.max(...speeds)).toBeCloseTo(50, 2);
  expect(Math.max(...downs)).toBeCloseTo(10, 2);
});

it("pro_height_between: height control between shapes is off at first, and its danger is told where it is set", async () => {
  const row = await onPage("height.between");
  expect(await row.getByRole("radio", { name: "no" }).getAttribute("aria-checked")).toBe("true");
  await row.getByText("Beware of high speeds in X and Y").waitFor();
  await row.getByRole("radio", { name: "yes" }).click();
  await expect.poll(() => setting("height.between")).toBe("true");
  if (shots) await page.screenshot({ path: `${shots}/between.png` });
  await page.locator(".setting").getByRole("radio", { name: "no" }).click();
  await expect.poll(() => setting("height.between")).toBe("false");
});

it("pro_job_jig_straddle: a path across the divider is warned about before the start", async () => {
  const jigs = await onPage("job.two_jigs");
  await jigs.getByRole("radio", { name: "yes" }).click();
  await expect.poll(() => setting("job.two_jigs")).toBe("true");
  const divider = (await onPage("job.divider_mm")).locator("input");
  await divider.fill("1250mm");
  await divider.press("Enter");
  await expect.poll(async () => Number(await setting("job.divider_mm"))).toBeCloseTo(1250, 3);
  await machined("jigs.rsg", "line 1150,50 1250,50; line 1200,100 1300,100");
  const findings = page.getByRole("list", { name: "Findings" });
  await findings.getByText("shape 2 lies across the divider and is not cut").waitFor();
  expect(await findings.textContent()).not.toContain("shape 1");
  expect((await stateOf(workshop)).messages.map(({ text }) => text).join()).not.toContain(
    "divider",
  );
  if (shots) await page.screenshot({ path: `${shots}/straddle.png` });
});
