/** Refusals say why and how to mend it: greyed buttons, a page that drives, a program beside it. */

import { spawn } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import {
  act,
  arm,
  comesToRest,
  commandDesk,
  kerf,
  openWorkshop,
  script,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
beforeAll(async () => {
  workshop = await openWorkshop({ rate: 20 });
});
afterAll(() => workshop?.close());

/** `kerf send LINE` to the server that is open: how it ended, and what it said. */
function send(line: string): Promise<{ code: number | null; said: string }> {
  const sender = spawn(kerf, ["send", line, "--server", workshop.address]);
  let said = "";
  sender.stderr.on("data", (data: Buffer) => {
    said += data.toString();
  });
  return new Promise((done) => sender.on("exit", (code) => done({ code, said })));
}

it("a greyed button tells at a press why it cannot be done", async () => {
  const page = await workshop.page();
  const start = page.getByRole("button", { name: "Start", exact: true });
  await start.waitFor();
  expect(await start.isDisabled()).toBe(true);
  // What is greyed takes no press; the place round it does, for a finger and a mouse alike.
  await start.click({ force: true });
  await page.locator(".notice", { hasText: "Open a file first." }).waitFor();
  expect(await page.locator(".action-place", { has: start }).getAttribute("title")).toBe(
    "Open a file first.",
  );
  await page.close();
});

it("the button of the keypad is greyed while a file runs, and says why", async () => {
  writeFileSync(join(workshop.parts, "long.sbp"), "MS,1,1\nM3,90,10,1\nM3,0,0,0\nEND\n");
  const page = await workshop.page();
  await script(workshop, "open", { name: "long.sbp" });
  const keypad = page.getByRole("button", { name: /^Move tool/ });
  expect(await keypad.isDisabled()).toBe(false);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.locator(".state", { hasText: "Running" }).waitFor();
  expect(await keypad.isDisabled()).toBe(true);
  await keypad.click({ force: true });
  await page.locator(".notice", { hasText: "The machine is busy." }).waitFor();
  await comesToRest(workshop);
  await expect.poll(() => keypad.isDisabled()).toBe(false);
  await page.close();
});

it("control is given up for another page, which has to arm the machine anew", async () => {
  const [page, other] = [await commandDesk(workshop), await commandDesk(workshop)];
  await arm(page);
  await page.getByText("You drive").waitFor();
  await other.getByText(/^Driven by/).waitFor();
  await page.getByRole("button", { name: "Give up control" }).click();
  await until(async () => (await stateOf(workshop)).lease === null, "nobody drives");
  for (const one of [page, other]) await one.locator(".state", { hasText: "Disarmed" }).waitFor();
  await arm(other);
  await other.getByText("You drive").waitFor();
  expect((await stateOf(workshop)).machine.armed).toBe(true);
  for (const one of [page, other]) await one.close();
});

it("kerf send tells beside a page that drives how the line gets through, and sends it when it may", async () => {
  const page = await commandDesk(workshop);
  await arm(page);
  const { motion } = await stateOf(workshop);
  const refused = await send("MX,1");
  expect(refused.code).toBe(1);
  expect(refused.said).toMatch(/somebody else drives: another page\. Press Give up control there/);
  expect(refused.said).toContain("kerf registry set uCommand 'MX,2'");
  await act(page, "give up");
  await until(async () => (await stateOf(workshop)).lease === null, "nobody drives");
  const disarmed = await send("MX,1");
  expect(disarmed.code).toBe(1);
  expect(disarmed.said).toContain("the machine is disarmed: arm it first");
  expect((await stateOf(workshop)).motion.at).toEqual(motion.at);
  expect(workshop.mistakes).toEqual([]);
});

it("STOP lies in its place on a tablet beside all that two pages show", async () => {
  const sizes = [1024, 1280].map((width) => ({ width, height: 768 }));
  const pages: Page[] = [];
  for (const size of sizes) pages.push(await workshop.page(size));
  const [tablet, desk] = pages as [Page, Page];
  await arm(tablet);
  await desk.getByRole("button", { name: "Take control" }).waitFor();
  await tablet.getByRole("button", { name: "Give up control" }).waitFor();
  for (const page of pages) {
    const wide = page.viewportSize()?.width ?? 0;
    const stop = await page.getByRole("button", { name: "STOP", exact: true }).boundingBox();
    expect(stop).toMatchObject({ x: wide - 150, width: 150 });
    const strip = page.locator(".strip a, .strip .mode, .strip .state, .strip button:not(.stop)");
    // Measured in one moment: the strip may change while one part after the other is asked.
    const measured = await strip.evaluateAll((all) =>
      all.map((one) => one.getBoundingClientRect()).map(({ x, width }) => ({ x, width })),
    );
    const boxes = measured.filter(({ width }) => width > 0).sort((a, b) => a.x - b.x);
    const right = boxes.map(({ x, width }) => x + width);
    const left = [...boxes.slice(1).map(({ x }) => x), stop?.x ?? 0];
    right.forEach((end, n) => {
      expect(end, `${wide}: part ${n}`).toBeLessThanOrEqual((left[n] ?? 0) + 0.5);
    });
    expect(await violations(page)).toEqual([]);
    await page.close();
  }
});
