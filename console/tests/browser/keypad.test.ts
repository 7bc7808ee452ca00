import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { arm, location, openWorkshop, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page();
});
afterAll(() => workshop?.close());

const wait = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
const stands = async () => {
  if ((await stateOf(workshop)).machine.state === "jogging") return false;
  const before = await location(page, "X");
  await wait(300);
  return before === (await location(page, "X"));
};

/** Holds a key for a while and waits until the machine stands; how far X went. */
async function held(keys: string[], ms: number): Promise<number> {
  const before = await location(page, "X");
  for (const key of keys) await page.keyboard.down(key);
  await wait(ms);
  for (const key of [...keys].reverse()) await page.keyboard.up(key);
  await until(stands, "the machine stands");
  return (await location(page, "X")) - before;
}

beforeEach(async () => {
  const keypad = page.getByRole("dialog", { name: "Keypad" });
  if ((await keypad.count()) === 0) await page.getByRole("button", { name: "Move tool" }).click();
  await keypad.waitFor();
});

it("sbp_con_keypad_mode: a machine that is not armed does not move, and says why", async () => {
  await page.getByText("Arm the machine first.").waitFor();
  expect(await held(["ArrowRight"], 300)).toBe(0);
  await page.keyboard.press("Escape");
  await arm(page);
});

it("sbp_con_keypad_open: arrows move as long as they are held, ESC closes", async () => {
  const way = await held(["ArrowRight"], 800);
  expect(way).toBeGreaterThan(0.2);
  expect(way).toBeLessThan(3);
  // Other software is told so: bit 4 of the status.
  const status = async () =>
    Number(await (await fetch(`${workshop.address}/api/registry/Status`)).text());
  expect((await status()) & 4).toBe(4);
  await page.keyboard.press("Escape");
  await expect.poll(async () => (await status()) & 4).toBe(0);
  await page.getByRole("dialog", { name: "Keypad" }).waitFor({ state: "detached" });
});

it("sbp_con_keypad_jog: with Ctrl at jog speed", async () => {
  const slow = await held(["ArrowRight"], 1000);
  const fast = await held(["Control", "ArrowRight"], 1000);
  expect(fast).toBeGreaterThan(slow * 1.5);
});

it("sbp_con_keypad_diag: / moves both axes alike", async () => {
  const y = await location(page, "Y");
  const way = await held(["/"], 700);
  expect(way).toBeGreaterThan(0.1);
  expect((await location(page, "Y")) - y).toBeCloseTo(way, 2);
});

it("sbp_con_keypad_fixed: D moves the distance that is set", async () => {
  await page.keyboard.press("d");
  expect(await held(["ArrowLeft"], 900)).toBeCloseTo(-0.1, 3);
  expect(await held(["ArrowLeft"], 900)).toBeCloseTo(-0.1, 3);
  await page.keyboard.press("d");
});

it("sbp_con_keypad_record: # and a digit keep the place", async () => {
  await page.keyboard.press("#");
  await page.keyboard.press("2");
  const kept = await page.locator(".recorded-list").textContent();
  const [x, y] = [await location(page, "X"), await location(page, "Y")];
  expect(kept).toBe(`J2,${x},${y}`);
});

it("sbp_con_keypad_pendant: e makes the mouse a pendant", async () => {
  await page.keyboard.press("e");
  const pendant = page.locator(".pendant");
  const axis = page.locator(".pendant-axis");
  expect(await axis.textContent()).toBe("X");
  const before = await location(page, "X");
  await pendant.hover();
  await page.mouse.down({ button: "right" });
  await wait(600);
  await page.mouse.up({ button: "right" });
  await until(stands, "the machine stands");
  expect(await location(page, "X")).toBeGreaterThan(before);
  await pendant.click({ button: "middle" });
  expect(await axis.textContent()).toBe("Y");
  await page.keyboard.press("e");
});

it("sbp_con_keypad_help: the keys are listed", async () => {
  const help = await page.locator(".keypad-help").textContent();
  for (const key of ["← →", "PgUp PgDn", "Ctrl", "Alt", "#", "D", "Esc"])
    expect(help).toContain(key);
});

it("stops when the window loses the focus, and starts nothing by itself", async () => {
  await page.keyboard.down("ArrowRight");
  await wait(300);
  await page.evaluate(() => dispatchEvent(new Event("blur")));
  await until(stands, "the machine stands");
  expect(await stands()).toBe(true);
  await page.keyboard.up("ArrowRight");
});

it("stops when the page is gone", async () => {
  const other = await workshop.page();
  await page.keyboard.down("ArrowRight");
  await wait(300);
  await page.close();
  await wait(1500);
  const x = await location(other, "X");
  await wait(500);
  expect(await location(other, "X")).toBe(x);
});
