/** A run that was cut short is offered to be taken up, and goes on where it was. */

import { existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import { act, arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
afterEach(() => workshop?.close());

const cutting = "SA\nMS,1,1\nSO,1,1\nMZ,-.1\nM2,6,0\nM2,6,3\nM2,0,3\nJZ,.5\nEND\n";

const state = (wanted: string) =>
  until(async () => (await stateOf(workshop)).machine.state === wanted, wanted);

/** The server dies in the middle of the second cut; another one begins where it was. */
async function powerCut(): Promise<Snapshot> {
  workshop = await openWorkshop({ rate: 3 });
  const folder = workshop.parts;
  writeFileSync(join(folder, "cut.sbp"), cutting);
  const page = await workshop.page();
  await arm(page);
  await script(workshop, "open", { name: "cut.sbp" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await page.getByRole("button", { name: "Start" }).click();
  await page.getByText("The spindle is about to start.").waitFor();
  await page.getByRole("button", { name: "OK" }).click();
  await until(async () => (await stateOf(workshop)).motion.at.working[1] > 20, "the second cut");
  const before = await stateOf(workshop);
  await workshop.kill();
  workshop = await openWorkshop({ rate: 3, folder });
  return before;
}

it("a run that a power cut ended is taken up after the safe way back, in each browser's sight", async () => {
  const before = await powerCut();
  const { interrupted, machine } = await stateOf(workshop);
  expect(interrupted).toMatchObject({ file: "cut.sbp", stopped: false, moved: true });
  expect(machine.armed).toBe(false);
  const [page, other] = [await workshop.page(), await workshop.page()];
  for (const one of [page, other]) {
    await one.locator(".state", { hasText: "not verified: home X Y Z, or zero them" }).waitFor();
  }
  await other.getByText("the run of cut.sbp was cut short behind line").waitFor();
  const offer = page.getByRole("button", { name: "Recover job…" });
  expect(await offer.isDisabled(), "not before somebody arms the machine").toBe(true);
  await arm(page);
  await offer.click();
  const sheet = page.getByRole("dialog", { name: "Recover job?" });
  expect(await sheet.textContent()).toContain("make sure that it is where the display says");
  await sheet.getByRole("button", { name: "Recover job" }).click();
  // The tool is up; nothing turns before somebody says that all is ready.
  await state("stopped");
  for (const one of [page, other]) await one.getByText("Is everything ready?").waitFor();
  const { motion, io, job } = await stateOf(workshop);
  expect(motion.at.working[2]).toBeGreaterThan(0);
  expect(io.outputs[0]?.on).toBe(false);
  // The plan is that of all of it: what was made before is made, and the rest is left.
  expect(job?.seconds).toBeCloseTo(before.job?.seconds ?? 0, 3);
  expect(motion.progress).toBeGreaterThan(0.2);
  // This simulated machine is three times as fast as the clock.
  expect(motion.remaining).toBeCloseTo(((job?.seconds ?? 0) * (1 - motion.progress)) / 3, 3);
  expect(await page.locator(".job-name strong").textContent()).toBe("cut.sbp");
  expect(await page.locator(".job-left").textContent()).not.toMatch(/–|0:00/);
  // The time before it was cut short is in the time so far: that which was planned for it.
  expect(motion.elapsed).toBeGreaterThan((0.8 * motion.progress * (job?.seconds ?? 0)) / 3);
  await page.getByRole("button", { name: "Resume" }).last().click();
  // As soon as it cuts on, it is as far as it was, and not further.
  const shares: number[] = [];
  await until(async () => {
    const now = await stateOf(workshop);
    if (now.motion.cutting && now.motion.speedMmS > 0) shares.push(now.motion.progress);
    return shares.length > 0 && now.motion.progress > before.motion.progress + 0.1;
  }, "it cuts on");
  expect(Math.min(...shares)).toBeGreaterThanOrEqual(motion.progress);
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is done");
  const after = await stateOf(workshop);
  expect(after.interrupted).toBeNull();
  expect(after.motion.at.working[0]).toBeCloseTo(0, 3);
  expect(after.motion.at.working[1]).toBeCloseTo(3 * 25.4, 3);
  await offer.waitFor({ state: "detached" });
});

it("whoever is not ready can take it up later, with keys only", async () => {
  await powerCut();
  const page = await workshop.page();
  await arm(page);
  const takesUp = async () => {
    await act(page, "recover");
    await page.getByText("Is everything ready?").waitFor();
  };
  await takesUp();
  await page.getByRole("button", { name: "Quit" }).press("Enter");
  await state("idle");
  await until(async () => (await stateOf(workshop)).interrupted?.stopped === true, "still offered");
  await takesUp();
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is done");
});

it("a job that a power cut ended is taken up by the page at the very place", async () => {
  // In the time of the world: how far a move has come is on record.
  workshop = await openWorkshop();
  const folder = workshop.parts;
  const lines = [1, 2].map((n) => `line 0,${40 * n} 400,${40 * n}`).join("; ");
  await script(workshop, "draw", { op: { op: "do", clauses: lines } });
  await script(workshop, "draw", { op: { op: "save", name: "part.rsg" } });
  await script(workshop, "machine", { drawing: "part.rsg" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  const page = await workshop.page();
  await page.getByRole("link", { name: "Operate" }).click();
  await arm(page);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  const cuts = async (line: number, from: number) => {
    const { motion } = await stateOf(workshop);
    return motion.cutting && motion.line === line && (motion.at.machine[0] ?? 0) > from;
  };
  await until(() => cuts(1, 150), "it cuts the first path");
  const before = (await stateOf(workshop)).motion.at.machine;
  await workshop.kill();
  workshop = await openWorkshop({ folder });
  expect((await stateOf(workshop)).interrupted).toMatchObject({ file: "part.rsm", moved: true });
  const next = await workshop.page();
  await next.getByRole("link", { name: "Operate" }).click();
  await arm(next);
  await next.getByRole("button", { name: "Recover job…" }).click();
  await next.getByRole("button", { name: "Recover job", exact: true }).click();
  await next.getByText("Is everything ready?").waitFor();
  expect((await stateOf(workshop)).io.outputs.some(({ on }) => on)).toBe(false);
  await next.getByRole("button", { name: "Resume" }).last().click();
  const seen: number[] = [];
  await until(async () => {
    const { motion, job } = await stateOf(workshop);
    const [x = 0, y = 0] = motion.at.machine;
    if (motion.cutting && Math.abs(y - 40) < 1e-6) seen.push(x);
    return job?.ended === "ok";
  }, "both paths are cut");
  // What was cut before is not cut again, and nothing is left out.
  expect(Math.min(...seen)).toBeGreaterThan((before[0] ?? 0) - 1);
  expect(seen.length).toBeGreaterThan(5);
  expect((await stateOf(workshop)).interrupted).toBeNull();
});

it("a drawing that was not saved is on the sheet again after a power cut", async () => {
  workshop = await openWorkshop();
  const folder = workshop.parts;
  const page = await workshop.page();
  await page.getByRole("link", { name: "Draw" }).click();
  await script(workshop, "draw", { op: { op: "do", clauses: "rect 0,0 100,60; circle 50,30 12" } });
  await until(async () => existsSync(join(folder, "drawing.draft")), "it is kept");
  await workshop.kill();
  workshop = await openWorkshop({ folder });
  const next = await workshop.page();
  await next.getByRole("link", { name: "Draw" }).click();
  await next.getByText("It was not saved when Kerf ended: here it is again.").waitFor();
  const { drawing } = await stateOf(workshop);
  expect(drawing).toMatchObject({ shapes: 2, changed: true, name: null });
  // Another one in its place asks first.
  await next.getByRole("button", { name: "Open…" }).click();
  await next.getByRole("alert").filter({ hasText: "not saved: they are lost" }).waitFor();
  await next.keyboard.press("Escape");
  await next.getByRole("button", { name: "New", exact: true }).click();
  await next.getByText("not saved: they are lost").waitFor();
  await next.getByRole("button", { name: "Cancel" }).click();
  expect((await stateOf(workshop)).drawing).toMatchObject({ shapes: 2 });
  await next.getByRole("button", { name: "New", exact: true }).click();
  await next.getByRole("button", { name: "Drawing: drop it and begin a new one" }).click();
  await until(async () => !existsSync(join(folder, "drawing.draft")), "who wants it not drops it");
});
