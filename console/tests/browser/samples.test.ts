/** A program that asks is drawn with sample answers that a person enters, and that stay with the file. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, expect, it } from "vitest";
import { act, openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
afterEach(() => workshop?.close());

const asks = [
  "SA",
  "MS,2,2",
  'INPUT "How wide?" &wide',
  'MSGBOX("Round corners?",YesNo,"Corners") &round',
  "M2,&wide,0",
  "M2,&wide,1",
  "M2,0,0",
  "",
].join("\n");

it("sample answers are entered, drawn, kept with the file, and known after a restart", async () => {
  workshop = await openWorkshop();
  const folder = workshop.parts;
  writeFileSync(join(folder, "asks.sbp"), asks);
  const ready = async () => {
    await script(workshop, "open", { name: "asks.sbp" });
    await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "drawn");
  };
  await ready();
  const page = await workshop.page();
  const extents = page.getByLabel("Extents and time");
  await extents.filter({ hasText: "0.000 … 0.000" }).waitFor();
  await page.getByText("It asks 2 questions: this is drawn with sample answers.").waitFor();
  await page.getByRole("button", { name: "Sample answers…" }).click();
  await page.getByLabel("How wide? (line 3)").fill("3/4+2");
  await page.getByRole("radio", { name: "No" }).click();
  expect(await violations(page)).toEqual([]);
  await page.getByRole("button", { name: "Draw with these" }).click();
  await extents.filter({ hasText: "0.000 … 2.750" }).waitFor();
  expect(readFileSync(join(folder, "asks.sbp.answers"), "utf8")).toBe("3:3/4+2\n4:No\n");
  expect(workshop.mistakes).toEqual([]);
  await workshop.kill();
  workshop = await openWorkshop({ folder });
  await ready();
  const again = await workshop.page();
  await again.getByLabel("Extents and time").filter({ hasText: "0.000 … 2.750" }).waitFor();
  // By the keyboard: the list of actions leads to them, Enter draws.
  await act(again, "sample answers");
  await again.getByLabel("How wide? (line 3)").fill("1");
  await again.keyboard.press("Enter");
  await again.getByLabel("Extents and time").filter({ hasText: "0.000 … 1.000" }).waitFor();
});
