/** Buttons of one's own with values, and the frame of a job. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, expect, it } from "vitest";
import {
  act,
  arm,
  openWorkshop,
  script,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
afterEach(() => workshop?.close());

const inch = 25.4;

it("a macro asks for its values, runs, and is there after a reload; the frame keeps above the work", async () => {
  workshop = await openWorkshop({ rate: 50 });
  writeFileSync(join(workshop.parts, "box.sbp"), "SA\nMZ,-.1\nM2,3,0\nM2,3,2\nM2,0,0\nJZ,.5\n");
  await script(workshop, "open", { name: "box.sbp" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  const page = await workshop.page();
  await arm(page);
  const macros = async () => {
    await act(page, "Macros");
    await page.getByRole("dialog", { name: "Macros" }).waitFor();
  };
  await macros();
  await page.getByRole("button", { name: "Frame the job" }).click();
  await page.getByText("Raise the tool above the work first").waitFor();
  await page.getByRole("button", { name: "New macro…" }).click();
  await page.getByLabel("Name").fill("Lift");
  await page.getByLabel("Lines of OpenSBP").fill("SA\nJZ,{height=1}");
  await page.getByRole("button", { name: "Keep" }).click();
  await page.reload();
  await arm(page);
  await macros();
  await page.getByRole("button", { name: "Lift", exact: true }).click();
  await page.getByLabel("height").fill("3/4");
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press("Enter");
  const z = async () => (await stateOf(workshop)).motion.at.working[2];
  await expect.poll(z).toBeCloseTo(0.75 * inch, 3);
  await macros();
  const reached = { x: 0, y: 0, z: Number.POSITIVE_INFINITY };
  await page.getByRole("button", { name: "Frame the job" }).click();
  await until(async () => {
    const { motion, job, machine } = await stateOf(workshop);
    const [x, y, height] = motion.at.working;
    reached.x = Math.max(reached.x, x);
    reached.y = Math.max(reached.y, y);
    reached.z = Math.min(reached.z, height);
    return (job?.command ?? "").includes("J2,3.0000,2.0000") && machine.state === "idle";
  }, "it went round");
  expect(reached.z).toBeCloseTo(0.75 * inch, 3);
  expect(workshop.mistakes).toEqual([]);
});
