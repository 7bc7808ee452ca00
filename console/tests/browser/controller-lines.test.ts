/** The console of the controller on the page: what is sent and answered, filtered, paused, saved, and a line to type. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import type { Controller } from "./controller";
import { driveController } from "./driven";
import { act, arm, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  const shop = await driveController();
  ({ controller, workshop, page } = shop);
  await arm(page);
  await open();
  return shop.close;
});

const sheet = () => page.getByRole("dialog", { name: "Console of the controller" });
const open = async () => {
  await act(page, "Console of the controller");
  await sheet().waitFor();
};
const lines = () => sheet().getByRole("region", { name: "Sent and answered" }).locator("p");
const holding = (text: string | RegExp) => lines().filter({ hasText: text });
const type = async (line: string) => {
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "it stands");
  await sheet().getByRole("textbox", { name: "Line" }).fill(line);
  await page.keyboard.press("Enter");
};

it("shows how the controller was asked about itself, without reports", async () => {
  await holding("$$").first().waitFor();
  await holding("$110=").first().waitFor();
  expect(await holding("<Idle|").count()).toBe(0);
  expect(await holding(/^\S+ ← Answered ok$/).count()).toBe(0);
  expect(await violations(page)).toEqual([]);
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/lines.png` });
});

it("shows reports and each ok when they are wanted, with the names of bytes that act at once", async () => {
  const routine = sheet().getByLabel("Status reports and ok");
  await routine.check();
  await holding("<Idle|").first().waitFor();
  await holding("status report asked").first().waitFor();
  await routine.uncheck();
  await holding("<Idle|").first().waitFor({ state: "detached" });
});

it("shows the answer to what is typed: a question, a move, and a refusal with its words", async () => {
  await sheet().getByLabel("Find").fill("[OPT:");
  const before = await holding("[OPT:").count();
  await type("$I");
  await until(async () => (await holding("[OPT:").count()) > before, "it answers $I");
  await sheet().getByLabel("Find").fill("G1");
  await type("MX,7");
  await holding(/→ Sent .*X177.8/)
    .first()
    .waitFor();
  await sheet().getByLabel("Find").fill("");
  await type("$N");
  await type("$PINS");
  await page.getByText(/\$PINS: error 3: it does not know this/).waitFor();
  await sheet().getByRole("radio", { name: "Errors" }).click();
  await holding(/error:3 it does not know this \$ command/)
    .first()
    .waitFor();
  expect(await holding("$110=").count()).toBe(0);
  await type("$X");
  await page.getByText(/\$X is no question that leaves the machine as it is/).waitFor();
});

it("stands still while it is paused, and goes on from there", async () => {
  await sheet().getByRole("radio", { name: "Sent", exact: true }).click();
  await sheet().getByRole("button", { name: "Pause" }).click();
  await type("MX,3");
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "it has moved");
  expect(await holding(/X76.2/).count()).toBe(0);
  await sheet().getByRole("button", { name: "Go on" }).click();
  await holding(/X76.2/).first().waitFor();
});

it("saves all of it, reports as well, and puts the last of it in the report of a problem", async () => {
  const saved = page.waitForEvent("download");
  await sheet().getByRole("button", { name: "Save to a file" }).click();
  const file = join(workshop.parts, "saved.txt");
  await (await saved).saveAs(file);
  const text = readFileSync(file, "utf8");
  expect(text).toMatch(/^\d\d:\d\d:\d\d\.\d{3} < <Idle\|/m);
  expect(text).toMatch(/^\S+ < error:3 {2}# it does not know this \$ command$/m);
  expect(text).toMatch(/^\S+ > \? {2}# status report asked$/m);
  const report = await (await fetch(`${workshop.address}/api/problems`)).text();
  expect(report).toMatch(/< error:3 {2}# it does not know/);
  expect(report).not.toContain("<Idle|");
});

it("shows that the cable was pulled", async () => {
  await sheet().getByRole("radio", { name: "Errors" }).click();
  controller.unplug();
  await holding(/• Connection .*the line is lost/)
    .first()
    .waitFor();
});
