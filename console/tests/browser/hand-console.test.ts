import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Act } from "../../src/wire/messages";
import { act, hold, keysOf, openWorkshop, stands, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;
/** Keys of the console that the page asked the server to press. */
const pressed: string[] = [];

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page();
  page.on("websocket", (socket) =>
    socket.on("framesent", ({ payload }) => {
      const { act } = JSON.parse(`${payload}`) as { act: Act };
      if (act.do === "key") pressed.push(act.key);
    }),
  );
  await page.reload();
  await page.locator(".state", { hasText: /./ }).waitFor();
  await chooses("Hand console");
  await panel().waitFor();
  await until(async () => (await stateOf(workshop)).lease !== null, "the page drives");
});
afterAll(() => workshop?.close());

/** An action of the palette. */
async function chooses(words: string): Promise<void> {
  await act(page, words);
}

const panel = () => page.getByRole("complementary", { name: "Hand console" });
const lines = async () =>
  (await panel().getByLabel("Screen of the hand console").locator("span").allTextContents()).map(
    (line) => line.trimEnd(),
  );
const shows = (top: string, bottom: string) => expect.poll(lines).toEqual([top, bottom]);
const click = (name: string) => panel().getByRole("button", { name, exact: true }).click();

it("pro_console_device__on_a_page: sixteen keys and two lines of twenty characters", async () => {
  await expect(panel().locator(".hand-console-key").count()).resolves.toBe(16);
  for (const line of await lines()) expect(line.length).toBeLessThanOrEqual(20);
  const row = panel().getByLabel("Screen of the hand console").locator("span").first();
  expect((await row.textContent())?.length).toBe(20);
  const overflows = await row.evaluate((it) => it.scrollWidth > it.clientWidth);
  expect(overflows, "twenty characters fit").toBe(false);
});

it("pro_console_pckeys: F12, keypad 0 and keypad Enter are Func, 0 and Enter", async () => {
  const typed: string[][] = [];
  const by = async (press: () => Promise<void>) => {
    pressed.length = 0;
    await press();
    await expect.poll(async () => (await lines())[0]).toBe("Cut speed mm/min:");
    typed.push([...pressed]);
    await click("Func");
    await shows("JOB: Untitled", "0x0mm #0");
  };
  await by(async () => {
    for (const key of ["F12", "Numpad0", "NumpadEnter"]) await page.keyboard.press(key);
  });
  await by(async () => {
    for (const key of ["Func", "0", "Enter"]) await click(key);
  });
  expect(typed[0]).toEqual(["U", "0", "\r"]);
  expect(typed[1]).toEqual(typed[0]);
  await page.keyboard.press("F9");
  await expect.poll(async () => (await lines())[0]).toContain("Select File");
  await page.keyboard.press("F9");
  await shows("JOB: Untitled", "0x0mm #0");
  pressed.length = 0;
  await page.keyboard.press("F10");
  await page.keyboard.press("F11");
  await expect.poll(() => pressed).toEqual(["S", "P"]);
  await click("Enter");
});

it("a key that is held while nobody drives takes the machine first, and is not lost", async () => {
  await chooses("Give up control");
  await until(async () => (await stateOf(workshop)).lease === null, "nobody drives");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  pressed.length = 0;
  await page.keyboard.down("F12");
  await shows("Enter function:", "0 Cut speed");
  await page.keyboard.up("F12");
  expect(pressed).toEqual(["U"]);
  await click("Func");
  await shows("JOB: Untitled", "0x0mm #0");
});

it("pro_console_mimic_screen: the page shows what the console shows", async () => {
  const told = async () => (await stateOf(workshop)).handConsole.lines;
  for (const keys of ["Func", "1", "8", "File", "1", "Stop", "Func"]) {
    await click(keys);
    await until(async () => `${await lines()}` === `${await told()}`, "the same lines");
  }
  await click("Func");
  await shows("Enter function:", "0 Cut speed");
  expect(await told()).toEqual(["Enter function:", "0 Cut speed"]);
  await click("Func");
});

it("moves the tool for as long as a digit is held, once the machine is armed", async () => {
  await page.keyboard.press("Numpad8");
  await shows("Disarmed", "Enter takes control");
  await page.keyboard.press("NumpadEnter");
  await until(async () => (await stateOf(workshop)).machine.armed, "armed");
  const y = async () => (await stateOf(workshop)).motion.at.machine[1] ?? 0;
  const hand = keysOf(page, ["Numpad8"]);
  await hold(workshop, hand, ({ motion }) => (motion.at.machine[1] ?? 0) > 5, "8 moves along Y");
  await hand.up();
  await until(() => stands(workshop), "the machine stands");
  const there = await y();
  expect(there).toBeGreaterThan(5);
  expect(await y(), "nothing moves any more").toBe(there);
});
