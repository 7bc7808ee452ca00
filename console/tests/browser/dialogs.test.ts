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

it("sbp_con_dialogs: questions are on every page, one answer closes them on all", async () => {
  const [here, there] = [await workshop.page(), await workshop.page()];
  await arm(here);
  await here.getByRole("button", { name: "Start" }).click();
  const size = "Diameter of the disk in inches";
  await here.getByText(size).waitFor();
  await there.getByText(size).waitFor();
  await there.reload();
  await there.getByText(size).waitFor();
  await there.keyboard.press("Enter");
  await here.getByText("Is the stock held down?").waitFor();
  await there.getByText("Is the stock held down?").waitFor();
  await here.getByRole("button", { name: "Yes" }).click();
  await there.getByText("safety glasses").waitFor();
  await there.keyboard.press("Enter");
  await here.getByText("finished").waitFor();
  await there.getByText("finished").waitFor();
  expect(workshop.mistakes).toEqual([]);
});
