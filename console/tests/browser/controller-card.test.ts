/** The card of a controller on the page: a file put there, looked through, run and followed, held, stopped; refusals. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import { Controller } from "./controller";
import { driveController } from "./driven";
import { overlaps } from "./overlaps";
import { sizes } from "./sizes";
import { act, arm, openWorkshop, stateOf, until, violations, type Workshop } from "./workshop";

let controller: Controller;
let workshop: Workshop;
let page: Page;

const files = {
  "box.sbp": "MS,2\nMX,-1\nMY,-1\n",
  "far.sbp": "SA\nMX,-1\nMX,-999\n",
  "wide.nc": `G21\n${`(${"x".repeat(200)})\n`.repeat(10_000)}G1 X-1 F900\nM30\n`,
};

beforeAll(async () => {
  const shop = await driveController(files, "card", "20=1", "130=400", "131=400", "132=400");
  ({ controller, workshop, page } = shop);
  controller.work("file long.nc G21|M3 S9000|G1 X-300 F900|G1 X0|M30");
  await act(page, "Card of the controller");
  await sheet().waitFor();
  return shop.close;
});

const sheet = () => page.getByRole("dialog", { name: "Card of the controller" });
const press = (name: string) => sheet().getByRole("button", { name, exact: true }).click();
const shot = async (name: string) => {
  if (!process.env.SHOTS) return;
  for (const theme of ["light", "dark"]) {
    await page.evaluate((worn) => document.documentElement.setAttribute("data-theme", worn), theme);
    for (const width of [1360, 390]) {
      await page.setViewportSize({ width, height: 800 });
      await page.screenshot({ path: `${process.env.SHOTS}/card-${name}-${theme}-${width}.png` });
    }
  }
  await page.setViewportSize({ width: 1360, height: 800 });
};
const machine = async () => (await stateOf(workshop)).machine;
const placeX = async () => (await controller.look()).place[0] ?? 0;
const stands = () => until(async () => (await machine()).state === "idle", "it stands");

async function put(name: string): Promise<void> {
  await sheet().getByLabel("File of the part folder").selectOption(name);
  await press("Put it on the card");
}

it("lists the files with their sizes", async () => {
  await press("List the files");
  await sheet().getByText("long.nc").waitFor();
  await sheet().getByText("1 file, 37 B.").waitFor();
  await stands();
  expect(await violations(page)).toEqual([]);
});

it("refuses a file beyond the limits with its line, and puts another one there", async () => {
  await put("far.sbp");
  await sheet()
    .getByRole("alert")
    .filter({ hasText: /^far\.sbp:3: .*X would go to/ })
    .waitFor();
  await shot("refused");
  await put("box.sbp");
  await sheet().getByText("box.nc").waitFor();
  await sheet().getByText("2 files").waitFor();
  await put("box.sbp");
  await press("Replace box.nc");
  await expect.poll(() => sheet().getByRole("alert").count()).toBe(0);
  await stands();
});

it("gives an upload up where it is cancelled, and at STOP", async () => {
  for (const ends of ["Cancel", "STOP"]) {
    await put("wide.nc");
    await sheet().getByRole("progressbar", { name: "Progress of the task" }).waitFor();
    await page.getByRole("button", { name: ends, exact: true }).first().click();
    await sheet().getByRole("alert").filter({ hasText: "it was stopped" }).waitFor();
    await stands();
    controller.work("card");
    expect(await controller.line()).toBe("box.nc long.nc");
  }
});

it("asks before a file is run, which the machine has to be armed for", async () => {
  await press("Run long.nc…");
  const question = sheet().getByRole("region", { name: "Run long.nc?" });
  // What came in its place is told with a failure: a refusal, or a notice.
  const said = async () => {
    const places = [question, sheet().getByRole("alert"), page.locator(".notice")];
    const all = (await Promise.all(places.map((place) => place.allTextContents())))
      .flat()
      .join("; ");
    return /It takes about [\d:]+/.exec(all)?.[0] ?? all;
  };
  // From where the machine stands to X-300 and back, at 900 mm a minute.
  await expect.poll(said, { timeout: 30_000 }).toMatch(/It takes about 0:4\d/);
  await question.getByText(/by itself, from where it stands, at its zero point G54/).waitFor();
  expect(await question.getByRole("button", { name: "Run it", exact: true }).isDisabled()).toBe(
    true,
  );
  await shot("question");
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press("Escape");
  await arm(page);
  await act(page, "Card of the controller");
});

it("follows a file that runs, holds it, goes on, and STOP ends it", async () => {
  await stands();
  await press("Run long.nc…");
  await press("Run it");
  await sheet().getByText("long.nc runs from the card").waitFor();
  await sheet()
    .getByText(/^\d % is done, about 0:[34]\d left/)
    .waitFor();
  await until(async () => (await placeX()) < -3, "it moves");
  await shot("running");
  await press("Hold");
  await until(async () => (await machine()).state === "held", "it is held");
  await sheet().getByText("long.nc is held").waitFor();
  await press("Resume");
  const held = await placeX();
  await until(async () => (await placeX()) < held - 2, "it goes on");
  expect((await controller.look()).rpm).toBe(9000);
  expect(await violations(page)).toEqual([]);
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "stopped", "it is over");
  await stands();
  expect((await controller.look()).rpm).toBe(null);
  const [x = 0, , z = 0] = (await controller.look()).place;
  expect(x).toBeGreaterThan(-300);
  expect(z).toBeLessThanOrEqual(0);
});

it("runs the file that it put there to its end, and copies one into the part folder", async () => {
  await press("Run box.nc…");
  await press("Run it");
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is over");
  const [x, y] = (await controller.look()).place;
  expect([x, y]).toEqual([-25.4, -25.4]);
  await press("Copy long.nc into the part folder");
  await sheet().getByText("long.nc is in the part folder.").waitFor();
  expect(readFileSync(join(workshop.parts, "long.nc"), "utf8")).toContain("G1 X-300 F900");
  await press("Open it: its preview is made");
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
});

it("follows a file that is begun at the controller's own panel, whose time is unknown", async () => {
  controller.work("file panel.nc G21|G1 X-300 F900|G1 X0|M30");
  controller.work("runs panel.nc");
  expect(await controller.line()).toBe("true");
  await page
    .locator(".job-name", { hasText: "panel.nc" })
    .getByText("runs from the controller's card")
    .waitFor();
  await act(page, "Card of the controller");
  await sheet()
    .getByText(/the time left is unknown/)
    .waitFor();
  await press("End the file: STOP");
  await until(async () => (await stateOf(workshop)).job?.ended === "stopped", "it is over");
  await stands();
});

it("deletes a file behind a question", async () => {
  await press("List the files");
  await press("Delete box.nc…");
  await press("Leave it there");
  await press("Delete box.nc…");
  await press("Delete it");
  await sheet().getByText("box.nc", { exact: true }).waitFor({ state: "detached" });
  controller.work("card");
  expect(await controller.line()).toBe("long.nc panel.nc");
});

it.each(sizes)("nothing lies over anything, at $width by $height", async (size) => {
  await page.setViewportSize(size);
  expect(await overlaps(page)).toEqual([]);
});

it("is followed and stopped where Kerf begins while it runs", async () => {
  const busy = new Controller("card");
  const port = await busy.line();
  busy.work("file long.nc G21|G1 X300 F900|G1 X0|M30");
  busy.work("runs long.nc");
  expect(await busy.line()).toBe("true");
  const late = await openWorkshop({ controller: `grbl:${port}` });
  const shown = await late.page();
  await shown.getByText("runs from the controller's card").first().waitFor();
  await shown.getByRole("button", { name: "STOP", exact: true }).click();
  await until(async () => (await stateOf(late)).job?.ended === "stopped", "it is over");
  await until(async () => (await stateOf(late)).controllerCard.has, "it is attached");
  await late.close();
  busy.unplug();
});
