/** The timing chart: what a job switches, and when, beside its motion. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Timing } from "../../src/wire/messages";
import { openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  const draw = (op: object) => script(workshop, "draw", { op });
  expect(await draw({ op: "new" })).toBe(200);
  expect(await draw({ op: "do", clauses: "line 0,40 100,40; line 0,80 100,80" })).toBe(200);
  expect(await draw({ op: "save", name: "part.rsg" })).toBe(200);
  expect(await script(workshop, "machine", { drawing: "part.rsg", anew: false })).toBe(200);
  page = await workshop.page({ width: 1360, height: 800 });
});
afterAll(() => workshop?.close());

const chart = () => page.getByRole("group", { name: "Timing chart" });
const line = (name: string) => chart().locator(`[data-line="${name}"]`);
const span = async () => [
  Number(await chart().getAttribute("data-from")),
  Number(await chart().getAttribute("data-to")),
];

async function opens(name: string): Promise<Timing> {
  if ((await stateOf(workshop)).opened?.name !== name) await script(workshop, "open", { name });
  await until(
    async () => (await stateOf(workshop)).opened?.preview.state === "ready",
    `${name} is previewed`,
  );
  const preview = (await stateOf(workshop)).opened?.preview;
  const key = preview?.state === "ready" ? preview.key : "";
  return (await fetch(`${workshop.address}/api/preview/${key}/timing`)).json() as Promise<Timing>;
}

/** The moments at which the drawn line of a bit goes up or down, from its pixels. */
async function drawnEdges(name: string): Promise<number[]> {
  const [from = 0, to = 0] = await span();
  const row = line(name);
  const width = Number(await row.locator("svg").getAttribute("width"));
  const path = (await row.locator(".timing-line").getAttribute("d")) ?? "";
  const corners = [...path.matchAll(/[ML]([\d.-]+) ([\d.-]+)/g)].map(([, x, y]) =>
    [x, y].map(Number),
  );
  return corners
    .filter(([x, y], n) => n > 0 && x === corners[n - 1]?.[0] && y !== corners[n - 1]?.[1])
    .map(([x = 0]) => from + (x / width) * (to - from));
}

it("pro_timing_inputs: a job's chart shows its inputs and outputs under the course of its axes, at the right times", async () => {
  const timing = await opens("part.rsm");
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByRole("button", { name: "Timing", exact: true }).click();
  await chart().waitFor();
  for (const axis of ["x", "y", "z"]) expect(await line(axis).count(), axis).toBe(1);
  const outputs = timing.lines.filter(({ kind }) => kind === "output");
  expect(outputs.map(({ name }) => name)).toContain("cut1");
  const unseen = await chart()
    .locator(".timing-line")
    .evaluateAll((all) => all.filter((one) => getComputedStyle(one).stroke === "none").length);
  expect(unseen, "lines without a colour").toBe(0);
  const pixel = timing.seconds / 1000;
  for (const { name, points } of outputs) {
    // A chart that has just come is drawn before it knows how wide it is.
    await expect
      .poll(async () => (await drawnEdges(name)).length, { message: name })
      .toBe(points.length);
    const drawn = await drawnEdges(name);
    for (const [n, [at]] of points.entries())
      expect(Math.abs((drawn[n] ?? 0) - at), `${name}: edge ${n + 1}`).toBeLessThan(2 * pixel);
  }
  const first = outputs.find(({ name }) => name === "cut1")?.points[0]?.[0] ?? 0;
  const words = await line("cut1").getByRole("img").getAttribute("aria-label");
  expect(words).toContain(`cut1: on ${first.toFixed(3)} s`);
  // The tool is down when the cut begins, and on its way across only then.
  const x = timing.lines.find(({ name }) => name === "x")?.points ?? [];
  const leaves = x.find(([at, value]) => at > first && value > 0)?.[0] ?? 0;
  expect(leaves).toBeGreaterThanOrEqual(first);
  await page.getByRole("dialog").getByLabel("Inputs").fill("arc@2=1, arc@3.5=0");
  await page.keyboard.press("Enter");
  await line("end_bottom_delay").waitFor();
  const [on = 0, off = 0] = await drawnEdges("end_bottom_delay");
  expect(Math.abs(on - 2) + Math.abs(off - 3.5)).toBeLessThan(4 * pixel);
  for (const theme of ["dark", "light"]) {
    await page.evaluate((name) => document.documentElement.setAttribute("data-theme", name), theme);
    expect(await violations(page), theme).toEqual([]);
    const shots = process.env.KERF_SHOTS;
    if (shots) await page.screenshot({ path: join(shots, `timing-${theme}.png`) });
  }
});

it("the time of the chart is zoomed and panned by wheel, keys and buttons", async () => {
  const [, end = 0] = await span();
  const box = await line("x").locator("svg").boundingBox();
  if (!box) throw new Error("there is no chart");
  await page.mouse.move(box.x + box.width / 2, box.y + 10);
  await page.mouse.wheel(0, -400);
  await expect.poll(async () => (await span())[1]).toBeLessThan(end);
  const [from = 0, to = 0] = await span();
  expect((from + to) / 2).toBeCloseTo(end / 2, 1);
  await chart().focus();
  await page.keyboard.press("ArrowRight");
  await expect.poll(async () => (await span())[0]).toBeGreaterThan(from);
  await page.keyboard.press("Home");
  await expect.poll(async () => (await span())[0]).toBe(0);
  await page.getByRole("button", { name: "More detail" }).click();
  await expect.poll(async () => (await span())[1]).toBeLessThan(to - from);
  await page.getByRole("button", { name: "All of it" }).click();
  await expect.poll(span).toEqual([0, end]);
});

it("a file without anything says so; a phone has room for it", async () => {
  await page.keyboard.press("Escape");
  writeFileSync(join(workshop.parts, "nothing.sbp"), "'Nothing.\nEND\n");
  writeFileSync(join(workshop.parts, "laser.sbp"), "SO,3,1\nM3,2,1,-.1\nPAUSE 1\nSO,3,0\nEND\n");
  await opens("nothing.sbp");
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByRole("button", { name: "Timing", exact: true }).click();
  await page.getByText("Nothing moves in this file").waitFor();
  await opens("laser.sbp");
  await line("output 3").waitFor();
  await page.setViewportSize({ width: 390, height: 800 });
  await expect
    .poll(() => page.evaluate(() => document.documentElement.scrollWidth))
    .toBeLessThan(391);
  const wide = await chart().evaluate((it) => it.scrollWidth - it.clientWidth);
  expect(wide).toBe(0);
  const shots = process.env.KERF_SHOTS;
  if (shots) await page.screenshot({ path: join(shots, "timing-phone.png") });
  expect(workshop.mistakes).toEqual([]);
});

it("from opening on the keys of the chart are heard, and say what everything is", async () => {
  await page.setViewportSize({ width: 1360, height: 800 });
  await page.keyboard.press("Escape");
  await chart().waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Timing", exact: true }).press("Enter");
  await chart().waitFor();
  await page.keyboard.press("Shift+ArrowRight");
  const told = page.locator(".timing-told");
  await expect.poll(() => told.textContent()).toMatch(/^At \d+\.\d{3} s: X .*output 3 on/);
  const first = await told.textContent();
  await page.keyboard.press("Shift+ArrowRight");
  await expect.poll(() => told.textContent()).not.toBe(first);
  const [, end = 0] = await span();
  await page.keyboard.press("+");
  await expect.poll(async () => (await span())[1]).toBeLessThan(end);
  const box = await line("x").locator("svg").boundingBox();
  await page.mouse.move((box?.x ?? 0) + 40, (box?.y ?? 0) + 10);
  await expect.poll(() => told.textContent()).toBe("");
});

it("a run that fails says so below its chart, and a chart made anew stays where it is", async () => {
  const bad = "&a = 0\nMX,3\nPAUSE 1\nMX,1/&a\nEND\n";
  writeFileSync(join(workshop.parts, "bad.sbp"), bad);
  writeFileSync(join(workshop.parts, "worse.sbp"), bad.replace("MX,3\nPAUSE 1\n", ""));
  await opens("bad.sbp");
  await page.getByText(/It ends at \d+\.\d{3} s: .*\(line 4\)/).waitFor();
  await page.getByRole("button", { name: "More detail" }).click();
  const [from, to] = await span();
  await page.getByRole("textbox", { name: "Inputs" }).fill("3@0=1");
  await page.keyboard.press("Enter");
  await line("input 3").waitFor();
  expect(await span()).toEqual([from, to]);
  await opens("worse.sbp");
  await page.getByText(/It ends at 0\.000 s: .*\(line 2\)/).waitFor();
});
