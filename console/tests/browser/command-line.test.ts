import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import {
  arm,
  carryOut,
  command,
  fullFace,
  location,
  openWorkshop,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 20 });
  page = await workshop.page();
  await fullFace(page);
  await arm(page);
});
afterAll(() => workshop?.close());

const line = () => page.getByLabel("Command line");
const hint = () => page.locator(".hint");
const ready = () => page.getByText("Ready", { exact: true }).waitFor();
const reaches = (axis: string, place: number) =>
  until(async () => (await location(page, axis)) === place, `${axis} at ${place}`);

it("sbp_con_commandline: two letters and parameters move the machine, ESC cancels, ↑ recalls", async () => {
  await line().pressSequentially("mx");
  expect(await hint().textContent()).toContain("X");
  await line().pressSequentially("2");
  expect(await line().inputValue()).toBe("MX,2");
  await page.keyboard.press("Enter");
  await reaches("X", 2);
  await ready();
  await line().pressSequentially("mx9");
  await page.keyboard.press("Escape");
  expect(await line().inputValue()).toBe("");
  await page.keyboard.press("ArrowUp");
  expect(await line().inputValue()).toBe("MX,2");
  await page.keyboard.press("Escape");
});

it("sbp_con_calc_param: the parameter line calculates and shows the result", async () => {
  await command(page, "mx12+11/16");
  await page.getByText("12+11/16 = 12.6875").waitFor();
  await until(async () => Math.abs((await location(page, "X")) - 12.6875) < 0.001, "X at 12.6875");
  await ready();
});

it("sbp_con_direct_immediate: what needs no parameters acts on the second key", async () => {
  await line().pressSequentially("mh");
  await reaches("X", 0);
  await ready();
});

it("sbp_cmd_home_immediate: MH and JH move on their second letter", async () => {
  for (const home of ["mh", "jh"]) {
    await carryOut(workshop, page, "m2,1,1");
    await reaches("Y", 1);
    await line().pressSequentially(home);
    await reaches("X", 0);
    await reaches("Y", 0);
    await ready();
    expect(await page.getByRole("dialog").count()).toBe(0);
    expect(await line().inputValue()).toBe("");
  }
});

it("sbp_cmd_uu: F10 and UU open the calculator, its result goes into the parameter", async () => {
  const calculator = page.getByRole("dialog", { name: "Calculator" });
  const result = calculator.locator(".calculator-result");
  const calculate = async (text: string) => {
    await calculator.getByLabel("Expression").fill(text);
    await until(async () => (await result.textContent()) === "12.6875", `${text} comes to 12.6875`);
  };
  await line().pressSequentially("vs");
  const sheet = page.getByRole("dialog", { name: /^VS/ });
  const jog = sheet.getByRole("textbox").nth(1);
  const others = await sheet.getByRole("textbox").nth(0).inputValue();
  await jog.fill("3");
  await page.keyboard.press("F10");
  await calculate("12+11/16");
  await calculator.getByRole("button", { name: /^Paste into/ }).click();
  await calculator.waitFor({ state: "detached" });
  expect(await jog.inputValue()).toBe("12.6875");
  expect(await sheet.getByRole("textbox").nth(0).inputValue()).toBe(others);
  await page.keyboard.press("Escape");
  await sheet.waitFor({ state: "detached" });

  await line().fill("MX,");
  await page.keyboard.press("F10");
  await calculate("12+11/16");
  await calculator.getByRole("button", { name: "Paste into command line" }).click();
  await until(async () => (await line().inputValue()) === "MX,12.6875", "the result is typed");
  await page.keyboard.press("Escape");

  await line().fill("UU");
  await page.keyboard.press("Enter");
  await calculator.waitFor();
  for (const screen of ["Edit", "Draw", "Settings", "Help", "Operate"]) {
    await page.keyboard.press("Escape");
    await page.getByRole("link", { name: screen }).click();
    await page.keyboard.press("F10");
    await calculator.waitFor();
  }
  await page.keyboard.press("Escape");
  await calculator.waitFor({ state: "detached" });
});

it("sbp_con_paramline: shows the order of parameters and opens the sheet with what is typed", async () => {
  await page.getByRole("button", { name: "Settings", exact: true }).first().focus();
  await line().click({ button: "right" });
  await page.getByRole("radio", { name: "Never" }).click();
  await page.getByRole("button", { name: "Done" }).click();
  await line().pressSequentially("cc4");
  expect(await page.locator(".hint-parameters li").count()).toBe(12);
  await page.getByRole("button", { name: "Fill-in sheet" }).click();
  expect(await page.getByRole("dialog").getByRole("textbox").first().inputValue()).toBe("4");
  await page.keyboard.press("Escape");
});

it("sbp_con_fillin_options: a right click chooses when sheets appear", async () => {
  await line().click({ button: "right" });
  await page.getByRole("radio", { name: "Always" }).click();
  await page.getByRole("button", { name: "Done" }).click();
  await line().pressSequentially("mx");
  await page.getByRole("dialog", { name: /MX/ }).waitFor();
  await page.keyboard.press("Escape");
  await line().click({ button: "right" });
  await page.getByRole("radio", { name: "Complex" }).click();
  await page.getByRole("button", { name: "Done" }).click();
  await line().pressSequentially("mx");
  expect(await line().inputValue()).toBe("MX,");
  await page.keyboard.press("Escape");
});

it("sbp_con_fillin_required: OK without what is required is refused and the field marked", async () => {
  await line().pressSequentially("cc");
  const sheet = page.getByRole("dialog", { name: /CC/ });
  await sheet.waitFor();
  await sheet.getByRole("button", { name: "OK" }).click();
  await sheet.getByText("This has to be given.").waitFor();
  expect(await sheet.locator("[data-invalid]").count()).toBeGreaterThan(0);
  await page.keyboard.press("Escape");
});

it("sbp_con_fillin: the sheet builds and runs the line that could have been typed", async () => {
  await line().pressSequentially("cc");
  const sheet = page.getByRole("dialog", { name: /CC/ });
  await sheet.waitFor();
  expect(await sheet.locator(".sheet-fields > div").count()).toBe(12);
  await sheet.getByRole("textbox").first().fill("4");
  expect(await sheet.locator(".sheet-line").textContent()).toBe("CC,4");
  await sheet.getByRole("button", { name: "OK" }).click();
  await sheet.waitFor({ state: "detached" });
  await page.locator(".job-name").getByText("CC,4").waitFor();
  await page.getByText("finished").waitFor();
  await ready();
});

it("sbp_con_fillin_recall: Recall last brings back what was used", async () => {
  await line().pressSequentially("cc");
  const sheet = page.getByRole("dialog", { name: /CC/ });
  await sheet.waitFor();
  const first = sheet.getByRole("textbox").first();
  expect(await first.inputValue()).toBe("");
  await sheet.getByRole("button", { name: "Recall last" }).click();
  expect(await first.inputValue()).toBe("4");
  await page.keyboard.press("Escape");
});

it("sbp_con_fillin_keys: Alt R resets, Alt D keeps the sheet away", async () => {
  await line().pressSequentially("cc");
  const sheet = page.getByRole("dialog", { name: /CC/ });
  const first = sheet.getByRole("textbox").first();
  await first.fill("7");
  await page.keyboard.press("Alt+r");
  expect(await first.inputValue()).toBe("");
  await page.keyboard.press("Alt+d");
  await page.keyboard.press("Escape");
  await line().pressSequentially("cc");
  expect(await line().inputValue()).toBe("CC,");
  await page.keyboard.press("Escape");
});

it("sbp_con_full: each menu lists its commands, choosing one is as typing it", async () => {
  const menus = page.getByRole("navigation", { name: "Commands" }).getByRole("button");
  expect(await menus.allTextContents()).toEqual(
    "Cuts File Help Jog Move Record Settings Tools Utilities Values Zero".split(" "),
  );
  await menus.getByText("Move").click();
  await page.getByRole("menuitem", { name: /^MX/ }).click();
  await page.getByRole("dialog", { name: /MX/ }).getByRole("textbox").first().fill("1");
  await page.getByRole("button", { name: "OK" }).click();
  await reaches("X", 1);
  await ready();
});

it("sbp_con_shortcuts: i, k, F10 and ESC", async () => {
  await page.keyboard.press("Escape");
  for (const [key, title] of [
    ["i", "Scratch pad"],
    ["k", "Keypad"],
    ["F10", "Calculator"],
  ] as const) {
    await page.locator("body").click({ position: { x: 700, y: 30 } });
    await page.keyboard.press(key);
    await page.getByRole("dialog", { name: title }).waitFor();
    await page.keyboard.press("Escape");
    await page.getByRole("dialog", { name: title }).waitFor({ state: "detached" });
  }
});

it("the settings page lists every command of the table", async () => {
  const table = (await (await fetch(`${workshop.address}/api/commands`)).json()) as {
    letters: string;
    parameters: unknown[];
  }[];
  expect(table.length).toBeGreaterThan(100);
  await page.goto(`${workshop.address}/settings`);
  expect(workshop.mistakes).toEqual([]);
});
