/** Jobs by the console: a drawing is machined, cut, paused, moved, gone on with, and begun at a clicked path. */

import { existsSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { boxOf, joined, noBox, place } from "../../src/draw/geometry/vec";
import { fitted, toPixels } from "../../src/draw/window";
import { margin } from "../../src/job/plan";
import type { JobView } from "../../src/wire/messages";
import {
  arm,
  hold,
  moment,
  openWorkshop,
  script,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

const themes = ["dark", "contrast", "light"];

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 4 });
  const draw = (op: object) => script(workshop, "draw", { op });
  const lines = [1, 2, 3].map((n) => `line 0,${40 * n} 1000,${40 * n}`).join("; ");
  expect(await draw({ op: "new" })).toBe(200);
  expect(await draw({ op: "do", clauses: lines })).toBe(200);
  expect(await draw({ op: "save", name: "part.rsg" })).toBe(200);
  expect(await draw({ op: "new" })).toBe(200);
  page = await workshop.page({ width: 1360, height: 800 });
});
afterAll(() => workshop?.close());

const begins = (state: string) =>
  until(async () => (await stateOf(workshop)).machine.state === state, state);
const finished = () =>
  until(async () => {
    const { job, machine } = await stateOf(workshop);
    return job?.ended === "ok" && machine.state === "idle";
  }, "the job is done");
/** Waits until the job cuts; the path that is cut then. */
const firstCut = async (): Promise<number> => {
  let line = 0;
  await until(async () => {
    const { motion } = await stateOf(workshop);
    line = motion.line;
    return motion.cutting;
  }, "it cuts");
  return line;
};
const machinePlace = async () => (await stateOf(workshop)).motion.at.machine;
const viewOf = async (): Promise<JobView> => (await fetch(`${workshop.address}/api/job`)).json();
/** So far from a number at most, mm. */
const near = (value: number) => expect.closeTo(value, 3);
const previewed = () =>
  until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");

it("pro_misc_modes: a drawing is only drawn; Machine makes its tool path, and the machine cuts that", async () => {
  await script(workshop, "open", { name: "part.rsg" });
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByText("is a drawing: it has no tool path yet").waitFor();
  await page.keyboard.press("F10");
  await page.locator(".notice", { hasText: "create the tool path first" }).waitFor();
  await script(workshop, "close");
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("button", { name: "part.rsg", exact: true }).click();
  expect(existsSync(join(workshop.parts, "part.rsm"))).toBe(false);
  await page.getByRole("button", { name: "Machine", exact: true }).click();
  await page.locator(".job-head", { hasText: "part.rsm" }).waitFor();
  expect(existsSync(join(workshop.parts, "part.rsm"))).toBe(true);
  await expect.poll(() => page.locator(".path-row").count()).toBe(3);
  expect((await stateOf(workshop)).opened?.kind).toBe("job");
  expect(await violations(page)).toEqual([]);
});

it("a job is cut, paused, moved away from, gone on with and finished, by mouse", async () => {
  await previewed();
  await arm(page);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  const deep = (await viewOf()).heights[2];
  await until(async () => {
    const [x, , z] = await machinePlace();
    return z < deep + 1e-6 && x > 40;
  }, "it cuts the first path");
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  await begins("stopped");
  const dialog = page.getByRole("dialog", { name: "Paused" });
  await dialog.waitFor();
  for (const theme of themes) {
    await page.evaluate(
      (chosen) => document.documentElement.setAttribute("data-theme", chosen),
      theme,
    );
    expect(await violations(page)).toEqual([]);
  }
  const [stood, y0, z] = await machinePlace();
  expect(z).toBeGreaterThan(deep + 1);
  await dialog.getByLabel("Move Z bottom by").fill("-0.02");
  await dialog.getByLabel("Move Z bottom by").press("Enter");
  await until(async () => {
    const bottom = (await stateOf(workshop)).job?.heights?.[2] ?? 0;
    return Math.abs(bottom - deep + 0.02 * 25.4) < 1e-6;
  }, "Z bottom is lower");
  // So fast from here on: 6 inches a second.
  const speed = dialog.getByLabel("Cutting speed");
  await until(async () => {
    // What is taken changes the question; what was said to the question before is refused.
    const before = (await stateOf(workshop)).asked?.number;
    if (before === undefined) return false;
    await speed.fill("360");
    await speed.press("Enter");
    await moment(300);
    const after = (await stateOf(workshop)).asked?.number;
    return after !== undefined && after !== before;
  }, "the speed is taken");
  // What was said holds, in this dialog, and where the page is loaded again.
  await expect.poll(() => speed.inputValue()).toBe("360");
  await page.reload();
  await expect.poll(() => speed.inputValue()).toBe("360");
  // Who loads the page again arms the machine to go on.
  await page.getByRole("button", { name: "Arm", exact: true }).click();
  await page.getByRole("button", { name: "Arm", exact: true }).waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Move the tool…" }).click();
  const up = page.getByRole("button", { name: "Y plus", exact: true });
  await up.waitFor();
  const box = await up.boundingBox();
  if (!box) throw new Error("there is no button");
  const { x, y } = box;
  const hand = {
    async down() {
      await page.mouse.move(x + 10, y + 10);
      await page.mouse.down();
    },
    up: () => page.mouse.up(),
  };
  await hold(workshop, hand, ({ motion }) => motion.at.machine[1] > y0 + 5, "the tool is moved");
  await hand.up();
  await begins("stopped");
  await page.getByRole("button", { name: "Close" }).click();
  await page.getByRole("button", { name: "Resume" }).last().click();
  const seen: (readonly number[])[] = [];
  let fastest = 0;
  await until(async () => {
    const { motion, job } = await stateOf(workshop);
    if (motion.cutting && motion.line === 1) {
      seen.push(motion.at.machine);
      fastest = Math.max(fastest, motion.speedMmS);
    }
    return motion.line > 1 || job?.ended === "ok";
  }, "the rest of the first path");
  const cut = seen.filter(([, , height]) => (height ?? 0) < deep - 0.5);
  expect(cut.length).toBeGreaterThan(0);
  expect(fastest).toBeGreaterThan(60);
  // At the very place, and from there to the end of the path, half a millimetre deeper.
  for (const [x = 0, y = 0] of cut) {
    expect(x).toBeGreaterThanOrEqual(stood - 1e-6);
    expect(y).toBeCloseTo(y0, 6);
  }
  await finished();
  await page.getByText("finished").waitFor();
});

const ports = () => page.getByRole("button", { name: "Out", exact: true }).click();
const lamp = (bit: string, on: boolean) =>
  page.locator(`[data-bit="${bit}"]${on ? ".port-on" : ":not(.port-on)"}`).waitFor();

it("pro_io_diag_read: a switch that closes is a bit of its port on the panel", async () => {
  await page.getByRole("link", { name: "Operate" }).click();
  await ports();
  await expect.poll(() => page.locator(".port-bit").count()).toBe(40);
  const byte = page.getByRole("region", { name: "Input port A" }).locator("output");
  const press = async (on: boolean) => {
    const { lease } = await stateOf(workshop);
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "In", exact: true }).click();
    await page.getByRole("switch", { name: "Input 15" }).click();
    await page.keyboard.press("Escape");
    await ports();
    await lamp("in.xhome", on);
    expect(lease).not.toBeNull();
  };
  await lamp("in.xhome", false);
  expect(await byte.textContent()).toBe("0x00");
  await press(true);
  expect(await byte.textContent()).toBe("0x04");
  await press(false);
  expect(await byte.textContent()).toBe("0x00");
  await page.keyboard.press("Escape");
});

it("pro_io_io_led: a lamp of the card follows each bit while a job runs", async () => {
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await ports();
  for (const bit of ["router", "job_running"]) await lamp(`out.${bit}`, true);
  for (const on of [true, false]) await lamp("out.cut1", on);
  expect(await violations(page)).toEqual([]);
  await finished();
  for (const bit of ["router", "job_running", "cut1", "tool1", "xstep"])
    await lamp(`out.${bit}`, false);
  await page.keyboard.press("Escape");
  await page.getByRole("link", { name: "Operate" }).click();
});

/** A plate of 50 by 30 mm, as another program writes it. */
const plate = [
  "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC",
  "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1",
  "10\n10\n20\n10\n10\n60\n20\n10\n10\n60\n20\n40\n10\n10\n20\n40\n0\nENDSEC\n0\nEOF\n",
].join("\n");

it("pro_misc_unified: a DXF is brought, opened, offset, machined and cut, all on this page", async () => {
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Open…" }).click();
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Upload…" }).click();
  const buffer = Buffer.from(plate);
  await (await chooser).setFiles([{ name: "plate.dxf", mimeType: "", buffer }]);
  // A file that is brought alone is opened as soon as it is there.
  await until(async () => (await stateOf(workshop)).drawing?.name === "plate.dxf", "it is opened");
  await page.getByRole("button", { name: "Settings…" }).click();
  const sheet = page.getByRole("dialog");
  await sheet.getByRole("textbox", { name: /^Offset/ }).fill("3mm");
  await sheet.getByRole("button", { name: "Apply" }).click();
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Machine", exact: true }).click();
  await page.locator(".job-head", { hasText: "plate.rsm" }).waitFor();
  await previewed();
  const { paths, finish, heights } = await viewOf();
  const along = (axis: 0 | 1) => paths[0]?.points.filter((_, n) => n % 3 === axis) ?? [];
  // The tool goes 3 mm outside of the plate.
  expect([Math.min(...along(0)), Math.max(...along(0))]).toEqual([7, 63].map(near));
  await page.getByRole("button", { name: "Start", exact: true }).click();
  const deep: (readonly number[])[] = [];
  await until(async () => {
    const { motion, job, machine } = await stateOf(workshop);
    if (motion.cutting) deep.push(motion.at.machine);
    return deep.length > 0 && job?.ended === "ok" && machine.state === "idle";
  }, "it is cut");
  for (const [x = 0, y = 0] of deep) {
    const away = Math.hypot(Math.max(10 - x, 0, x - 60), Math.max(10 - y, 0, y - 40));
    expect(away).toEqual(near(3));
  }
  await page.locator(".job-status", { hasText: "finished" }).waitFor();
  await expect.poll(() => page.locator(".job-times").first().textContent()).toMatch(/^100 %/);
  // At the place of finish, above the material.
  expect((await machinePlace()).slice(0, 3)).toEqual([...finish, heights[0]].map(near));
});

it("pro_job_start_mouse: a click on a path shows its number and begins the job with it, unless one runs", async () => {
  // 24 paths in an array, as `kerf draw --list` numbers them.
  await script(workshop, "draw", { op: { op: "new" } });
  const lines = Array.from({ length: 24 }, (_, n) => {
    const [x, y] = [(n % 6) * 30, Math.floor(n / 6) * 30];
    return `line ${x},${y} ${x + 20},${y}`;
  });
  await script(workshop, "draw", { op: { op: "do", clauses: lines.join("; ") } });
  await script(workshop, "draw", { op: { op: "save", name: "array.rsg" } });
  await script(workshop, "machine", { drawing: "array.rsg" });
  await page.locator(".job-head", { hasText: "array.rsm" }).waitFor();
  await expect.poll(() => page.locator(".path-row").count()).toBe(24);
  await previewed();
  const { paths } = await viewOf();
  const wanted = paths[16];
  if (!wanted) throw new Error("there are no 24 paths");
  const sheet = page.getByRole("application", { name: "Paths of the job" });
  const box = await sheet.boundingBox();
  if (!box) throw new Error("there is no sheet");
  // All of it is in sight, as the page shows it at first.
  const [[fx, fy]] = [(await viewOf()).finish];
  const corners = paths.flatMap(({ points }) => [
    place(points[0] ?? 0, points[1] ?? 0),
    place(points[3] ?? 0, points[4] ?? 0),
  ]);
  const all = [...corners, place(0, 0), place(fx, fy)]
    .map((at) => boxOf(at, at))
    .reduce(joined, noBox);
  const [x0 = 0, y0 = 0] = wanted.points;
  const pixel = toPixels(fitted(all, box, margin), box, place(x0 + 10, y0));
  const at = { x: box.x + pixel.x, y: box.y + pixel.y };
  await page.mouse.move(at.x, at.y);
  await page.locator(".job-hover", { hasText: "Path 17," }).waitFor();
  await page.mouse.click(at.x, at.y);
  await expect.poll(() => page.getByLabel("Begins with path").inputValue()).toBe("17");
  expect(wanted.number).toBe(17);
  await previewed();
  await page.keyboard.press("F10");
  expect(await firstCut()).toBe(17);
  // While it runs its picture stands there; the paths are in their list.
  await page.locator(".path-row button").nth(3).click();
  await page.locator(".notice", { hasText: "A job runs" }).waitFor();
  expect((await viewOf()).start).toBe(17);
  await finished();
});

it("pro_job_step_start: F10 and HTTP start alike, and the second Start cuts", async () => {
  const state = await stateOf(workshop);
  const lease = state.lease?.number ?? 0;
  await page.getByRole("link", { name: "Settings" }).click();
  await page.getByLabel("Search settings").fill("double_start");
  await page.getByRole("radio", { name: "yes" }).click();
  // It is in force with the next preview.
  const changes = async () => (await fetch(`${workshop.address}/api/settings?changes`)).text();
  await until(async () => (await changes()).includes("double_start"), "the setting is changed");
  await page.getByRole("link", { name: "Operate" }).click();
  await previewed();
  expect(lease).toBeGreaterThan(0);
  await page.keyboard.press("F10");
  const dialog = page.getByRole("dialog", { name: "Start with shape 17?" });
  await dialog.waitFor();
  await dialog.getByRole("button", { name: "The next path" }).click();
  await page.getByRole("dialog", { name: "Start with shape 18?" }).waitFor();
  await page.keyboard.press("F10");
  expect(await firstCut()).toBe(18);
  await finished();
  expect(workshop.mistakes).toEqual([]);
});
