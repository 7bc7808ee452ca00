/** A run on a controller, cut short by the death of the server, is taken up there, and by no other machine. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, expect, it } from "vitest";
import { Controller } from "./controller";
import { arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

const controller = new Controller();
let workshop: Workshop;
afterAll(async () => {
  await workshop?.close();
  controller.unplug();
});

const cutting = "SA\nMS,1,1\nSO,1,1\nPAUSE .2\nMZ,-.1\nM2,4,0\nM2,4,2\nM2,0,2\nJZ,.5\nSO,1,0\n";

it("a run on a controller goes on at the very place after the server died", async () => {
  const name = `grbl:${await controller.port()}`;
  workshop = await openWorkshop({ controller: name });
  const folder = workshop.parts;
  writeFileSync(join(folder, "cut.sbp"), cutting);
  const before = await workshop.page();
  await arm(before);
  await script(workshop, "open", { name: "cut.sbp" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await before.getByRole("button", { name: "Start", exact: true }).click();
  await before.getByRole("button", { name: "OK" }).click();
  await until(async () => ((await controller.look()).place[1] ?? 0) > 10, "the second cut");
  await workshop.kill();

  workshop = await openWorkshop({ folder });
  expect(
    (await stateOf(workshop)).interrupted,
    "the simulated machine has nothing to do with it",
  ).toBe(null);
  await workshop.kill();

  workshop = await openWorkshop({ controller: name, folder });
  expect((await stateOf(workshop)).interrupted).toMatchObject({ file: "cut.sbp", moved: true });
  const page = await workshop.page();
  await arm(page);
  await page.getByRole("button", { name: "Recover job…" }).click();
  const sheet = page.getByRole("dialog", { name: "Recover job?" });
  await sheet.getByRole("button", { name: "Recover job" }).click();
  await page.getByText("Is everything ready?").waitFor();
  const lifted = await controller.look();
  expect(lifted.place[2], "the tool is up").toBeGreaterThan(0);
  expect(lifted.rpm, "nothing turns before somebody says that all is ready").toBe(null);
  await page.getByRole("button", { name: "Resume" }).last().click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is done");
  const { place } = await controller.look();
  expect(place.map((mm) => Math.round(mm * 100) / 100)).toMatchObject([0, 50.8, 12.7]);
  expect((await stateOf(workshop)).interrupted).toBe(null);
});
