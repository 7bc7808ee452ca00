import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({
    parts: ["07-questions/questions.sbp"],
    open: "questions.sbp",
    rate: 20,
  });
});
afterAll(() => workshop?.close());

/** Waits for a question. */
const asks = (page: Page, text: string) =>
  page.locator(".question-text", { hasText: text }).waitFor();

it("sbp_con_dialogs: questions are on every page, one answer closes them on all", async () => {
  const [here, there] = [await workshop.page(), await workshop.page()];
  await arm(here);
  await here.getByRole("button", { name: "Start" }).click();
  await asks(here, "Diameter of the disk in inches");
  await asks(there, "Diameter of the disk in inches");
  await there.reload();
  await asks(there, "Diameter of the disk in inches");
  await there.keyboard.press("Enter");
  await asks(here, "Is the stock held down?");
  await asks(there, "Is the stock held down?");
  await here.getByRole("button", { name: "Yes" }).click();
  await asks(there, "safety glasses");
  // Any page fills in a value; the machine goes on by the one that drives.
  await there.getByRole("note").getByText("Another page drives.").waitFor();
  await there.keyboard.press("Enter");
  await asks(here, "safety glasses");
  await here.keyboard.press("Enter");
  await asks(there, "The spindle is about to start.");
  await here.getByRole("button", { name: "OK" }).click();
  await here.getByText("finished").waitFor();
  await there.getByText("finished").waitFor();
  expect(workshop.mistakes).toEqual([]);
  for (const page of [here, there]) await page.close();
});

it("sbp_flow_pause_timed_msg: the comment above a pause is shown as long as it lasts, on every page; nobody presses", async () => {
  const text =
    "'Finished the first Cut-Out, Moving on to the Second\nPAUSE 700\nMX,1\nPAUSE 100\nMX,2\nEND\n";
  writeFileSync(join(workshop.parts, "pause.sbp"), text);
  const [here, there] = [await workshop.page(), await workshop.page()];
  await script(workshop, "open", { name: "pause.sbp" });
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === "pause.sbp" && opened.preview.state === "ready";
  }, "previewed");
  await here.getByRole("button", { name: "Start" }).click();
  const card = (page: Page) => page.getByRole("status", { name: "Pause" });
  const words = "Finished the first Cut-Out, Moving on to the Second";
  for (const page of [here, there]) await card(page).getByText(words).waitFor();
  await there.reload();
  await card(there).getByText(words).waitFor();
  expect(
    await card(here)
      .getByText(/^Goes on by itself in \d+ s$/)
      .count(),
  ).toBe(1);
  await card(here).getByText(words).waitFor({ state: "detached" });
  expect((await stateOf(workshop)).motion.t, "not before its time").toBeGreaterThanOrEqual(700);
  // The next pause has no comment right above it.
  await card(here).getByText("Pause", { exact: true }).waitFor();
  await card(here).waitFor({ state: "detached" });
  await card(there).waitFor({ state: "detached" });
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "the job is done");
  expect((await stateOf(workshop)).motion.t).toBeGreaterThanOrEqual(800);
});
