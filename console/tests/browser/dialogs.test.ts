import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, openWorkshop, type Workshop } from "./workshop";

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
  await there.keyboard.press("Enter");
  await asks(here, "The spindle is about to start.");
  await there.getByRole("button", { name: "OK" }).click();
  await here.getByText("finished").waitFor();
  await there.getByText("finished").waitFor();
  expect(workshop.mistakes).toEqual([]);
});
