/** A tilted plate is probed on the page of a pretended controller, and a program cuts along it. */

import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { act, arm, moment, script, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController({
    "plate.nc": "G21 F600\nG0 X0 Y0\nG1 Z-0.5\nX20 Y10\nG0 Z3\n",
  });
  ({ controller, workshop, page } = shop);
  await arm(page);
  return shop.close;
});

const shot = async (name: string) => {
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/${name}.png` });
};

/** Starts what is open by a button, and waits for its end: its word. */
async function runs(button: string): Promise<string> {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  await page.getByRole("button", { name: button, exact: true }).click();
  const isOver = async () => {
    const { job } = await stateOf(workshop);
    return (job?.run ?? 0) > before && job?.ended !== null;
  };
  // A busy computer drives the controller slowly.
  for (let looks = 0; looks < 400 && !(await isOver()); looks += 1) await moment(500);
  await until(isOver, "it is over");
  return (await stateOf(workshop)).job?.ended ?? "";
}

it("lays a grid over the open file and probes it", async () => {
  await script(workshop, "open", { name: "plate.nc" });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === "plate.nc" && opened.preview.state === "ready";
  }, "it is drawn");
  await act(page, "Height map: probe a surface");
  await page.getByRole("dialog", { name: "Height map" }).waitFor();
  await page.getByRole("button", { name: "Bounds of the open file" }).click();
  await until(async () => (await page.getByLabel("Width, X").inputValue()) === "0.7874", "bounds");
  await page.getByLabel("Columns").fill("2");
  await page.getByLabel("Rows").fill("2");
  await page.getByLabel("First touch, a second").fill("0.2");
  await page.getByRole("button", { name: "Make the program" }).click();
  await until(async () => {
    const { opened, job } = await stateOf(workshop);
    const isReady = opened?.name === "probe_heights.sbp" && opened.preview.state === "ready";
    return job?.ended === "ok" && isReady;
  }, "it is made and drawn");
  controller.work("plate -0.5 0.02 0");
  controller.work("pins P");
  await page.getByText("Input 1 is closed").waitFor();
  controller.work("pins ");
  expect(await runs("Start probing")).toBe("ok");
  await page.getByText("4 of 4 places are probed.").waitFor();
  await page.getByRole("button", { name: "Use it" }).click();
  await until(async () => (await stateOf(workshop)).heightMap !== null, "it is in force");
  const { heightMap } = await stateOf(workshop);
  expect(heightMap?.columns).toBe(2);
  expect((heightMap?.highest ?? 0) - (heightMap?.lowest ?? 0)).toBeCloseTo(0.4, 1);
  expect(await violations(page)).toEqual([]);
  await shot("height-map");
});

it("cuts along the plate, says so, and goes back to flat", async () => {
  await page.getByRole("button", { name: "Close", exact: true }).click();
  const status = page.getByRole("button", { name: /^Height map: on, / });
  await status.waitFor();
  await script(workshop, "open", { name: "plate.nc" });
  await page.getByText("Z follows the height map.").waitFor();
  await shot("height-map-operate");
  // What the probing printed stands beside Start.
  await page.getByRole("region", { name: "Message screen" }).waitFor();
  expect(await runs("Start")).toBe("ok");
  await page.getByRole("button", { name: "Close the message screen" }).click();
  const { motion } = await stateOf(workshop);
  expect((motion.at.machine[2] ?? 0) - 3).toBeCloseTo(-0.1, 1);
  await status.click();
  await page.getByRole("button", { name: "Take the map off" }).click();
  await page.getByText("No height map is in force").waitFor();
  await page.getByText("Z follows the height map.").waitFor({ state: "detached" });
});
