/** Measures how soon a part file of 100 MB can be typed into, and the time of a key: `npm run bench`. */

import { afterAll, beforeAll, it } from "vitest";
import { openWorkshop, type Workshop } from "../browser/workshop";
import { type Figure, tell } from "./record";
import { writeRows } from "./rows";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop();
});
afterAll(async () => {
  await workshop?.close();
  tell("the console's editor", figures);
});

const figures: Figure[] = [];

/** Lines of short moves that are 100 MB together. */
const moves = 4_000_000;

/** Script by which the page notes tasks and typed text, from its first line on. */
const notes = `
  window.longest = 0;
  window.keys = [];
  new PerformanceObserver((list) => {
    for (const task of list.getEntries()) window.longest = Math.max(window.longest, task.duration);
  }).observe({ entryTypes: ["longtask"] });
  new PerformanceObserver((list) => {
    for (const event of list.getEntries()) if (event.name === "keydown") window.keys.push(event.duration);
  }).observe({ type: "event", durationThreshold: 16 });
`;

const figure = (what: string, value: number, goal?: number): Figure => ({
  input: "100 MB",
  what,
  value,
  unit: "ms",
  ...(goal === undefined ? {} : { goal }),
});

it("a part file of 100 MB in the editor", async () => {
  writeRows(workshop.parts, "rows.sbp", moves);
  const page = await workshop.page();
  await page.evaluate(() =>
    sessionStorage.setItem("kerf.edited", JSON.stringify({ name: "rows.sbp", opened: "" })),
  );
  await page.addInitScript(notes);
  await page.goto(workshop.address);
  await page.locator(".location-number").first().waitFor();
  await new Promise((resolve) => setTimeout(resolve, 2000));
  await page.evaluate("window.longest = 0");
  const begin = performance.now();
  await page.getByRole("link", { name: "Edit" }).click();
  await page.locator(".cm-line", { hasText: "M3," }).first().waitFor();
  figures.push(figure("its first lines in the editor", performance.now() - begin));
  figures.push(figure("longest task of the page meanwhile", await longest(), 50));
  await page.locator(".cm-content").click();
  for (const place of ["Control+Home", "Control+End"]) {
    await page.keyboard.press(place);
    await page.keyboard.type("' a comment\n", { delay: 100 });
  }
  const keys = ((await page.evaluate("window.keys")) as number[]).sort((a, b) => a - b);
  figures.push(
    figure("key, 19 of 20 with the picture of it", keys[Math.floor(keys.length * 0.95)] ?? 16, 50),
  );
  figures.push(figure("longest task of the page while typing", await longest(), 50));
  await page.getByText("Each line was checked by itself").waitFor({ timeout: 120_000 });
  const saving = performance.now();
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.locator(".edit-changed").waitFor({ state: "detached", timeout: 120_000 });
  figures.push(figure("saved", performance.now() - saving));
  await page.close();

  async function longest(): Promise<number> {
    const most = (await page.evaluate("window.longest")) as number;
    await page.evaluate("window.longest = 0");
    return most;
  }
}, 600_000);
