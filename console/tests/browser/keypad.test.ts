import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import type { Snapshot } from "../../src/wire/messages";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  hold,
  keysOf,
  location,
  moment,
  openWorkshop,
  stands,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop();
  page = await workshop.page();
});
afterAll(() => workshop?.close());

const inch = 25.4;
const at = async () => {
  const [x, y] = (await stateOf(workshop)).motion.at.working;
  return { x: x / inch, y: y / inch };
};
const standing = () => until(() => stands(workshop), "the machine stands");

/** Holds keys until X has gone so far, lets go, and waits until it stands; how far it went, in inches. */
async function held(keys: string[], inches = 0.3): Promise<number> {
  const before = (await at()).x;
  const goes = ({ motion }: Snapshot) => motion.at.working[0] / inch - before > inches;
  const hand = keysOf(page, keys);
  await hold(workshop, hand, goes, `${keys.join()} moves`);
  await hand.up();
  await standing();
  return (await at()).x - before;
}

beforeEach(async () => {
  const keypad = page.getByRole("dialog", { name: "Keypad" });
  if ((await keypad.count()) === 0) await page.getByRole("button", { name: "Move tool" }).click();
  await keypad.waitFor();
});

it("sbp_con_keypad_mode: a machine that is not armed does not move, and says why", async () => {
  await page.getByText("Arm the machine first.").waitFor();
  const before = await at();
  await page.keyboard.press("ArrowRight", { delay: 300 });
  await standing();
  expect(await at()).toEqual(before);
  await page.keyboard.press("Escape");
  await arm(page);
});

it("sbp_con_keypad_open: arrows move as long as they are held, ESC closes", async () => {
  expect(await held(["ArrowRight"])).toBeGreaterThan(0.3);
  const there = await at();
  await moment(300);
  expect(await at(), "nothing moves any more").toEqual(there);
  // Other software is told so: bit 4 of the status.
  const status = async () =>
    Number(await (await fetch(`${workshop.address}/api/registry/Status`)).text());
  expect((await status()) & 4).toBe(4);
  await page.keyboard.press("Escape");
  await expect.poll(async () => (await status()) & 4).toBe(0);
  await page.getByRole("dialog", { name: "Keypad" }).waitFor({ state: "detached" });
});

it("sbp_con_keypad_jog: with Ctrl at jog speed", async () => {
  const { cutMmS, jogMmS } = (await stateOf(workshop)).speeds;
  for (const [keys, speed] of [
    [["ArrowRight"], cutMmS[0]],
    [["Control", "ArrowRight"], jogMmS[0]],
  ] as const) {
    const hand = keysOf(page, keys);
    const near = ({ motion }: Snapshot) => Math.abs(motion.speedMmS / speed - 1) < 0.02;
    await hold(workshop, hand, near, `${keys.join()} moves at ${speed} mm/s`);
    await hand.up();
    await standing();
  }
  expect(jogMmS[0]).toBeGreaterThan(cutMmS[0]);
});

it("sbp_con_keypad_diag: / moves both axes alike", async () => {
  const { y } = await at();
  const way = await held(["/"]);
  expect((await at()).y - y).toBeCloseTo(way, 2);
});

it("sbp_con_keypad_fixed: D moves the distance that is set", async () => {
  await page.keyboard.press("d");
  /** Holds the key until the step is made; how far it went. */
  const step = async () => {
    const x = (now: Snapshot) => now.motion.at.working[0] / inch;
    const from = (await at()).x;
    const hand = keysOf(page, ["ArrowLeft"]);
    const stood = await hold(workshop, hand, (now) => x(now) < from - 1e-6, "it moves");
    await standing();
    await moment(200);
    await hand.up();
    await standing();
    const way = (await at()).x - x(stood);
    expect(way, "it goes no further, however long the key is held").toBeGreaterThan(-0.1001);
    return way;
  };
  // Where the link is slow for a moment a step ends early.
  await until(async () => Math.abs((await step()) + 0.1) < 1e-4, "a step of 0.1 in");
  await until(async () => Math.abs((await step()) + 0.1) < 1e-4, "one more");
  await page.keyboard.press("d");
});

const steps = (on: Page, unit: string) =>
  on.getByRole("radiogroup", { name: `Steps, ${unit}` }).getByRole("radio");

it("a step is one press: its button, then a direction", async () => {
  expect(await steps(page, "in").allTextContents()).toEqual(["0.001", "0.01", "0.1", "1"]);
  await page.getByRole("radio", { name: "0.01", exact: true }).click();
  expect(await page.getByLabel("Distance", { exact: true }).inputValue()).toBe("0.01");
  const right = page.getByRole("button", { name: "X plus", exact: true });
  // Where the link is slow for a moment a step ends early.
  await until(async () => {
    const from = (await at()).x;
    await right.click({ delay: 250 });
    await standing();
    return Math.abs((await at()).x - from - 0.01) < 1e-4;
  }, "a step of 0.01 in");
  await page.getByRole("radio", { name: "While held" }).click();
  expect(await page.getByRole("radio", { name: "0.01", checked: true }).count()).toBe(0);
});

it("sbp_con_keypad_record: # and a digit keep the place", async () => {
  await page.keyboard.press("#");
  await page.keyboard.press("2");
  const kept = await page.locator(".recorded-list").textContent();
  const [x, y] = [await location(page, "X"), await location(page, "Y")];
  expect(x).toBeCloseTo((await at()).x, 3);
  expect(kept).toBe(`J2,${x},${y}`);
});

it("sbp_con_keypad_pendant: e makes the mouse a pendant", async () => {
  await page.keyboard.press("e");
  const pendant = page.locator(".pendant");
  const axis = page.locator(".pendant-axis");
  expect(await axis.textContent()).toBe("X");
  const before = (await at()).x;
  await pendant.hover();
  const hand = {
    down: () => page.mouse.down({ button: "right" }),
    up: () => page.mouse.up({ button: "right" }),
  };
  const goes = ({ motion }: Snapshot) => motion.at.working[0] / inch > before + 0.1;
  await hold(workshop, hand, goes, "the pendant moves it");
  await hand.up();
  await standing();
  await pendant.click({ button: "middle" });
  expect(await axis.textContent()).toBe("Y");
  await page.keyboard.press("e");
});

it("sbp_con_keypad_help: the keys are listed", async () => {
  const help = await page.locator(".keypad-help").textContent();
  for (const key of ["← →", "PgUp PgDn", "Ctrl", "Alt", "#", "D", "Esc"])
    expect(help).toContain(key);
});

it("steps are in millimetres where the page reads millimetres", async () => {
  const other = await openWorkshop({ rate: 100 });
  try {
    const desk = await commandDesk(other);
    await arm(desk);
    await carryOut(other, desk, "VD,,,1");
    await command(desk, "SK");
    await steps(desk, "mm").first().waitFor();
    expect(await steps(desk, "mm").allTextContents()).toEqual(["0.01", "0.1", "1", "10"]);
    await desk.getByRole("radio", { name: "10", exact: true }).click();
    if (process.env.SHOTS) await desk.screenshot({ path: `${process.env.SHOTS}/keypad.png` });
    await until(async () => {
      const from = (await stateOf(other)).motion.at.working[1];
      await desk.getByRole("button", { name: "Y plus", exact: true }).click({ delay: 250 });
      await until(() => stands(other), "the machine stands");
      return Math.abs((await stateOf(other)).motion.at.working[1] - from - 10) < 1e-3;
    }, "a step of 10 mm");
  } finally {
    await other.close();
  }
});

/** Holds the arrow until the tool moves. */
async function moves(): Promise<void> {
  const before = (await at()).x;
  const goes = ({ motion }: Snapshot) => motion.at.working[0] / inch > before + 0.05;
  await hold(workshop, keysOf(page, ["ArrowRight"]), goes, "it moves");
}

it("stops when the window loses the focus, and starts nothing by itself", async () => {
  await moves();
  await page.evaluate(() => dispatchEvent(new Event("blur")));
  await standing();
  const there = await at();
  await moment(300);
  expect(await at()).toEqual(there);
  await page.keyboard.up("ArrowRight");
});

it("stops when the page is gone", async () => {
  await moves();
  await page.close();
  await standing();
  const there = await at();
  await moment(500);
  expect(await at()).toEqual(there);
});
