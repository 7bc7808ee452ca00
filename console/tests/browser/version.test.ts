/** A page of another version than the server's keeps STOP, hold and disarm, and says that it is to be reloaded. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, comesToRest, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop();
  writeFileSync(join(workshop.parts, "long.sbp"), "SA\nMS,1,1\nM2,20,10\nM2,0,0\nEND\n");
});
afterAll(() => workshop?.close());

it("keeps STOP, hold and disarm, and nothing else", async () => {
  const driver = await workshop.page();
  await arm(driver);
  await script(workshop, "open", { name: "long.sbp" });
  await driver.locator(".job-name", { hasText: "long.sbp" }).waitFor();
  await until(
    async () => (await stateOf(workshop)).opened?.preview.state === "ready",
    "it is previewed",
  );

  const page = await workshop.browser.newPage();
  let told = "0.0.1";
  const asked: string[] = [];
  await page.routeWebSocket(/\/ws$/, (link) => {
    const server = link.connectToServer();
    server.onMessage((text) =>
      link.send(String(text).replace(/"kerf":"[^"]+"/, (own) => (told ? `"kerf":"${told}"` : own))),
    );
    link.onMessage((text) => {
      const { act } = JSON.parse(String(text)) as { act: { do: string } };
      if (act.do !== "ping") asked.push(act.do);
      server.send(text);
    });
  });
  await page.goto(workshop.address);
  await page.getByRole("heading", { name: "Kerf was changed: reload this page" }).waitFor();
  await page.getByText("driven by Kerf 0.0.1.").waitFor();
  const buttons = await page.getByRole("button").allTextContents();
  expect(buttons).toEqual(["Disarm", "Hold", "STOP", "Reload"]);
  expect(await page.getByRole("link").count()).toBe(0);
  for (const key of ["k", "i", "F10", "Control+k", "Control+o", "Enter", "m"]) {
    await page.keyboard.press(key);
  }
  expect(await page.getByRole("dialog").count()).toBe(0);
  expect(asked).toEqual([]);

  await driver.getByRole("button", { name: "Start" }).click();
  const moves = (state: string) =>
    until(async () => (await stateOf(workshop)).machine.state === state, state);
  await moves("running");
  await page.getByRole("button", { name: "Hold" }).click();
  await moves("held");
  await driver.getByRole("button", { name: "Resume" }).click();
  await moves("running");
  await page.keyboard.press("Space");
  await moves("stopped");
  await page.getByRole("button", { name: "Disarm" }).click();
  await until(async () => !(await stateOf(workshop)).machine.armed, "it is disarmed");
  await comesToRest(workshop);

  told = "";
  await page.getByRole("button", { name: "Reload" }).click();
  await page.locator(".state", { hasText: "Disarmed" }).waitFor();
});
