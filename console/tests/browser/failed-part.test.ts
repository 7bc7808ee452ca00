import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Snapshot, ToPage } from "../../src/wire/messages";
import { arm, openWorkshop, script, stands, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({ parts: ["01-first-cut/first-cut.sbp"], open: "first-cut.sbp" });
});
afterAll(() => workshop?.close());

const failed = (page: Page) => page.getByRole("heading", { name: "This part of the page failed" });

/** Starts the program, so that something can be stopped. */
async function running(page: Page): Promise<void> {
  await arm(page);
  await page.getByRole("button", { name: "Start" }).click();
  let answered = 0;
  await until(async () => {
    const { asked, motion } = await stateOf(workshop);
    // It goes on by the page that drives, and by nobody else; what was answered may be told a moment longer.
    if (asked && asked.number !== answered) {
      await page.getByRole("dialog").getByRole("button", { name: "OK", exact: true }).click();
      answered = asked.number;
    }
    return motion.speedMmS > 0;
  }, "running");
}

/** STOP is seen, and it stops; then the program is given up. */
async function stops(page: Page): Promise<void> {
  await page.getByRole("button", { name: "STOP", exact: true }).click();
  await until(() => stands(workshop), "stopped");
  await until(async () => {
    const { machine, asked } = await stateOf(workshop);
    if (asked) await script(workshop, "answer", { question: asked.number, answer: "Quit" });
    return machine.state === "idle";
  }, "given up");
}

/** From now on the page is told snapshots in which a section is no such thing. */
async function mistold(page: Page, section: keyof Snapshot, value: object): Promise<void> {
  await page.routeWebSocket(/\/ws$/, (socket) => {
    const server = socket.connectToServer();
    server.onMessage((message) => {
      const told = JSON.parse(String(message)) as ToPage;
      if (told.tell === "snapshot") Object.assign(told.snapshot, { [section]: value });
      socket.send(JSON.stringify(told));
    });
  });
  await page.reload();
}

it("a screen that fails leaves STOP, the strip and the other screens", async () => {
  const page = await workshop.page();
  await running(page);
  await mistold(page, "io", {});
  await failed(page).waitFor();
  await stops(page);
  await page.getByRole("link", { name: "Help" }).click();
  await page.getByRole("main").getByRole("heading").first().waitFor();
  expect(await failed(page).count()).toBe(0);
  await page.close();
});

it("a strip that fails leaves STOP", async () => {
  const page = await workshop.page();
  await running(page);
  await mistold(page, "machine", { state: "running", why: { not: "a text" } });
  await page.getByRole("button", { name: "This part failed" }).first().waitFor();
  await stops(page);
  await page.close();
});

it("a screen that cannot be fetched any more is told, and loading the page again brings it", async () => {
  const page = await workshop.page();
  await page.route(/\/assets\/DrawScreen-.*\.js$/, (route) => route.abort());
  await page.getByRole("link", { name: "Draw" }).click();
  await failed(page).waitFor();
  await page.getByRole("button", { name: "STOP", exact: true }).waitFor();
  await page.unroute(/\/assets\/DrawScreen-.*\.js$/);
  await page.getByRole("button", { name: "Load the page again" }).click();
  await page.getByRole("application", { name: "Shapes of the drawing" }).waitFor();
  expect(await failed(page).count()).toBe(0);
  await page.close();
});

it("what the page cannot read ends the link, and a new one brings all of it", async () => {
  const page = await workshop.page();
  let garbled = false;
  let links = 0;
  await page.routeWebSocket(/\/ws$/, (socket) => {
    links += 1;
    const server = socket.connectToServer();
    server.onMessage((message) => {
      socket.send(garbled || links > 1 ? message : "{");
      garbled = true;
    });
  });
  await page.reload();
  await page.locator(".state", { hasText: /Ready|Disarmed/ }).waitFor();
  expect(links).toBe(2);
  await page.close();
});
