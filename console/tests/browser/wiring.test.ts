import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { Board } from "./board";
import { act, arm, kerf, openWorkshop, stateOf, violations, type Workshop } from "./workshop";

let board: Board;
let port: string;
const folder = mkdtempSync(join(tmpdir(), "kerf-wiring-"));
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  board = new Board();
  port = await board.port();
  // Patient with a computer that does much else.
  execFileSync(kerf, ["set", "--data", folder, "board.deadline_s=2", "board.watch_s=3"]);
  // A switch that opens when it is pressed, at a pin that is pulled up.
  board.work("pin 10 1");
  workshop = await openWorkshop({ folder });
  page = await workshop.page();
});
afterAll(async () => {
  await workshop?.close();
  board?.unplug();
});

const question = (words: string | RegExp) =>
  page.locator(".wiring-question", { hasText: words }).waitFor();
const press = (name: string) => page.getByRole("button", { name, exact: true }).click();
const shot = (name: string) =>
  process.env.SHOTS ? page.screenshot({ path: `${process.env.SHOTS}/wiring-${name}.png` }) : null;

/** Fills the entry of a question in, and goes on. */
const give = async (asked: string, entry: string) => {
  await question(asked);
  await page.locator(".wiring-entry input").fill(entry);
  await press("Next");
};

const begin = async (into: string) => {
  await page.getByLabel("Port of the board").fill(port);
  await page.getByLabel("File of the machine").fill(into);
  await press("Begin");
};

it("wires nothing while the machine is disarmed", async () => {
  await act(page, "Wire a board of a printer");
  await page.getByRole("dialog", { name: "Wire a board" }).waitFor();
  expect(await page.getByRole("button", { name: "Begin" }).isDisabled()).toBe(true);
  expect(await violations(page)).toEqual([]);
  expect(await page.getByRole("button", { name: "Look for boards" }).isDisabled()).toBe(true);
  await page.keyboard.press("Escape");
  await arm(page);
  await act(page, "Wire a board of a printer");
});

it("lists the ports of this computer with the boards at them", async () => {
  await page.getByLabel("Port of the board").fill(port);
  await press("Look for boards");
  const row = page.getByRole("radio", { name: port });
  await row.waitFor();
  await page
    .locator(".wiring-port", { hasText: port })
    .getByText("rp2040, firmware fake-1")
    .waitFor();
  await shot("found");
  await page.getByLabel("Port of the board").fill("/dev/none");
  expect(await row.isChecked()).toBe(false);
  await row.check();
  expect(await page.getByLabel("Port of the board").inputValue()).toBe(port);
  const sold = page.getByRole("combobox", { name: "Board that is sold" });
  expect(await sold.locator("option").allTextContents()).toContain("BIGTREETECH SKR Pico V1.0");
  expect(await violations(page)).toEqual([]);
});

it("tells why nobody answers at a port", async () => {
  await page.getByLabel("Port of the board").fill("/dev/none");
  await press("Look for boards");
  const row = page.locator(".wiring-port", { hasText: "/dev/none" });
  await row.getByText("there is no serial port /dev/none").waitFor();
  expect(await row.getByRole("radio").isDisabled()).toBe(true);
});

/** Pins of X, of the motor of Y as told, none of Z, and one output. */
async function givesPins(y: string, torch = false): Promise<void> {
  await give("Motor X", "gpio0 gpio1");
  await give("Home switch of X", "^!gpio10");
  await give("Motor Y", y);
  await give("Home switch of Y", "");
  await give("Motor Z", "");
  await give("Home switch of Z", "");
  await question("two motors");
  await press("No");
  await give("current", "");
  await give("Outputs by number", "1 gpio20");
  await give("Inputs by number", "1 gpio12");
  await question("a torch");
  await press(torch ? "Yes" : "No");
  if (!torch) return;
  await give("the voltage of its arc", "-");
  await give("two switches of its head", "gpio13");
  await page.getByText("Name two pins, too high and too low").waitFor();
  await give("two switches of its head", "gpio13 gpio14");
}

it("asks for the pins, and takes them once the board does", async () => {
  await begin("mine.toml");
  await shot("begins");
  await givesPins("gpio0 gpio3");
  await page.getByText("pin `gpio0` is used twice").waitFor();
  await shot("twice");
  await givesPins("-", true);
  await question("X goes 1 mm");
  await shot("goes");
  expect(await violations(page)).toEqual([]);
});

it("turns a motor that goes the wrong way round, and measures its steps", async () => {
  await press("Turn it");
  await question("Which way did X go?");
  await shot("went");
  await press("It moved the wrong way");
  await question("X goes 1 mm");
  await press("Turn it");
  await give("Which way", "0.5");
  await question("X goes 1 mm");
  await press("Turn it");
  await question("Which way");
  await press("It moved right");
});

/** Waits until a switch is shown as pressed or open. */
const shows = (name: string, pin: string, state: string) =>
  page
    .locator(".wiring-switches li", { hasText: name })
    .filter({ hasText: pin })
    .filter({ hasText: state })
    .waitFor();

it("shows each switch as it is, whichever question is open", async () => {
  await question("leave its home switch alone");
  await shows("Home switch of X", "^!gpio10", "open");
  await shows("Input 1", "gpio12", "open");
  await shows("Input 17", "gpio13", "open");
  await shows("Input 20", "gpio14", "open");
  board.work("pin 12 1");
  await shows("Input 1", "gpio12", "pressed");
  await shows("Home switch of X", "^!gpio10", "open");
  await shot("switches");
  expect(await violations(page)).toEqual([]);
  board.work("pin 12 0");
  await shows("Input 1", "gpio12", "open");
});

it("sees the home switch, and the output", async () => {
  await press("Done");
  await question("press its home switch");
  board.work("pin 10 0");
  await shows("Home switch of X", "^!gpio10", "pressed");
  await press("Done");
  await page.getByText("its home switch is seen").waitFor();
  await question("Output 1 goes on");
  await press("Switch it on");
  await question("Did it go on?");
  await press("It did");
});

it("tries the speed, and writes the file of the machine", async () => {
  await question("X: try its speed");
  await press("Try");
  await question("X at 10 mm/s");
  await press("It came back to its place");
  await question("X at 20 mm/s");
  await press("It did not");
  await page.getByText("X: at most 5 mm/s").waitFor();
  await question("X: try its acceleration");
  await press("Leave it as it is");
  await page.getByText("written: mine.toml").waitFor();
  await shot("written");
  const file = readFileSync(join(folder, "mine.toml"), "utf8");
  expect(file).toContain('x = "gpio0 !gpio1"');
  expect(file).toContain('inputs = "1 gpio12, 17 gpio13, 20 gpio14"');
  expect(await board.counts()).toEqual([0]);
});

it("ends at once when it is stopped, and writes nothing", async () => {
  await begin("other.toml");
  await question("Motor X");
  await page.getByRole("button", { name: /^STOP/ }).first().click();
  await page.getByText("stopped; nothing is written").waitFor();
  expect((await stateOf(workshop)).wiring?.step).toBeNull();
});
