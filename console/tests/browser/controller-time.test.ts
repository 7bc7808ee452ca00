/** The time that is told of the open file is that of the controller, by its settings as they are now. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Controller } from "./controller";
import {
  act,
  arm,
  command,
  commandDesk,
  openWorkshop,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  controller = new Controller("120=400", "121=400");
  const port = await controller.port();
  const part = "01-first-cut/first-cut.sbp";
  workshop = await openWorkshop({
    controller: `grbl:${port}`,
    parts: [part],
    open: "first-cut.sbp",
  });
  page = await commandDesk(workshop);
});
afterAll(async () => {
  await workshop?.close();
  controller?.unplug();
});

/** Seconds of the open file as the page tells them: `0:52`, or with hours. */
async function told(): Promise<number> {
  const facts = page.getByLabel("Extents and time").getByText(/^\d+(:\d\d)+(\.\d+)?$/);
  const text = (await facts.textContent({ timeout: 5000 }).catch(() => "")) ?? "";
  return text.split(":").reduce((all, part) => all * 60 + Number(part), 0);
}

it("follows $120 and $121 that are typed at the command line", async () => {
  await until(async () => (await told()) > 0, "the time is told");
  const before = await told();
  await arm(page);
  await command(page, "$120=20");
  await page.getByText("the controller keeps $120=20.000 now, and kept 400.000 before").waitFor();
  await command(page, "$121=20");
  await until(async () => (await told()) > before * 1.2, "the time is longer");
  expect(await controller.setting(121)).toBe(20);
  expect((await stateOf(workshop)).machine.state).toBe("idle");
});

it("follows what somebody at the controller sets, without being connected anew", async () => {
  const slow = await told();
  controller.says("$120=400");
  controller.says("$121=400");
  await until(async () => (await told()) < slow * 0.9, "the time is shorter again");
});

it("learns from a finished run, tells by how many, and forgets it", async () => {
  const facts = page.getByLabel("Extents and time");
  expect(await facts.getByText("Learned").count()).toBe(0);
  // Long enough to count, and its own file: two jogs of 100 mm.
  await command(page, "JX,4");
  await facts.getByText(/^1 run here: motion takes \d\.\d\d times as long as estimated/).waitFor();
  expect((await stateOf(workshop)).machine.pace?.runs).toBe(1);
  expect(await violations(page)).toEqual([]);
  await facts.getByRole("button", { name: "Forget" }).click();
  await facts.getByText("Learned").waitFor({ state: "detached" });
  expect((await stateOf(workshop)).machine.pace).toBeNull();
  await act(page, "Forget what runs have shown");
  await page.getByText("Nothing was learned of this machine's time.").waitFor();
});
