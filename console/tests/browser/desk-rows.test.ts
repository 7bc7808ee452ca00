/** Rows of the manuals about the screens around a job: recorder, messages, preview, help. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  hold,
  keysOf,
  location,
  openWorkshop,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 20 });
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  file("hello.sbp", 'PRINT "Hello"\nEND\n');
  file("words.sbp", "'alpha\nMX,1\n'beta\nEND\n");
  file("moves.sbp", 'PRINT "a"\nMX,30\nVD,,,,,,,0\nMX,0\nEND\n');
  file("hides.sbp", 'PRINT "a"\nPAUSE\nVD,,,,,,,0\nMX,0\nEND\n');
  file("again.sbp", 'PRINT "a"\nVD,,,,,,,0\nPRINT "b"\nEND\n');
  file("inner.sbp", "PAUSE 1\nMX,0\nPAUSE 60\n");
  file("outer.sbp", "SA\n\nFP,inner.sbp,,,1\nEND\n");
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

const line = () => page.getByLabel("Command line");
const ready = () => page.locator(".state", { hasText: "Ready" }).waitFor();
const run = (text: string) => carryOut(workshop, page, text);
const screen = () => page.getByRole("region", { name: "Message screen" });

beforeEach(async () => {
  for (let n = 0; n < 3 && (await page.getByRole("dialog").count()) > 0; n += 1) {
    await page.keyboard.press("Escape");
  }
  if (!page.url().endsWith("/")) await page.getByRole("link", { name: "Operate" }).click();
  await line().waitFor();
  await line().fill("");
});

it("sbp_cmd_ra: recording is on at first, a full dot; RI empties it to a circle, RA fills it", async () => {
  const mark = page.locator(".full-recorder .recorder-mark");
  expect(await mark.getAttribute("aria-label")).toBe("Commands are recorded");
  await run("MX,0.5");
  await line().pressSequentially("ri");
  await page.getByLabel("Commands are not recorded").waitFor();
  await run("MX,0.25");
  await line().pressSequentially("ra");
  await page.getByLabel("Commands are recorded").waitFor();
  await run("MX,0.75");
  const { recorder } = await stateOf(workshop);
  expect(recorder.lines).toContain("MX,0.5");
  expect(recorder.lines).not.toContain("MX,0.25");
  expect(recorder.lines.at(-1)).toBe("MX,0.75");
});

it("sbp_cmd_ri: what is typed while it is off is not in the list, and the list stays", async () => {
  const before = (await stateOf(workshop)).recorder.lines;
  await line().pressSequentially("ri");
  await page.getByLabel("Commands are not recorded").waitFor();
  await run("MX,0.125");
  const { lines, on } = (await stateOf(workshop)).recorder;
  expect(on).toBe(false);
  expect(lines.filter((text) => !/^RI/i.test(text))).toEqual(before);
  await line().pressSequentially("ra");
  await page.getByLabel("Commands are recorded").waitFor();
});

it("sbp_cmd_r_list: the list shows commands newest last, a double click runs one", async () => {
  await run("MX,1");
  await run("MX,2");
  await page.getByRole("button", { name: "Recorder" }).click();
  const rows = page.getByRole("listbox", { name: "Recorded commands" }).getByRole("option");
  expect(await rows.last().textContent()).toBe("MX,2");
  await rows
    .filter({ hasText: /^MX,1$/ })
    .last()
    .dblclick();
  await until(async () => (await location(page, "X")) === 1, "X at 1");
  await ready();
  await page.getByLabel("Part file").fill("kept.sbp");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  // What is saved is shown in the editor, and the list waits until it was looked at.
  await page.getByRole("region", { name: "The program waits" }).waitFor();
  await page.locator(".cm-content", { hasText: "MX,2" }).waitFor();
  await page.getByRole("button", { name: "Done, go on" }).click();
  await ready();
  expect(readFileSync(join(workshop.parts, "kept.sbp"), "utf8")).toContain("MX,2");
});

it("sbp_cmd_si_shortcut: i opens the scratch pad", async () => {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press("i");
  await page.getByRole("dialog", { name: "Scratch pad" }).waitFor();
  await page.keyboard.press("Escape");
});

it("sbp_cmd_si_replay: Alt L brings the last lines, a double click sends one again", async () => {
  await run("MX,1.5");
  await run("MX,2.5");
  await line().press("i");
  const pad = page.getByRole("dialog", { name: "Scratch pad" });
  await pad.getByRole("textbox").fill("");
  await pad.getByRole("textbox").press("Alt+l");
  expect((await pad.getByRole("textbox").inputValue()).split("\n").slice(-2)).toEqual([
    "MX,1.5",
    "MX,2.5",
  ]);
  await pad.getByRole("option", { name: "MX,1.5" }).last().dblclick();
  await until(async () => (await location(page, "X")) === 1.5, "X at 1.5");
  await ready();
  await page.keyboard.press("Escape");
});

it("sbp_io_print_window: PRINT opens the message screen with its line", async () => {
  expect(await screen().count()).toBe(0);
  await run("FP,hello.sbp");
  await screen().waitFor();
  expect(await screen().locator("pre").textContent()).toContain("Hello");
});

it("sbp_io_print_suppress: VD with comments off closes it until the next PRINT", async () => {
  await run("FP,hello.sbp");
  await screen().waitFor();
  await run("VD,,,,,,,0");
  await screen().waitFor({ state: "detached" });
  await run("FP,hello.sbp");
  await screen().waitFor();
  await page.getByRole("button", { name: "Close the message screen" }).click();
});

it("sbp_io_print_suppress: VD in a file closes it too, until the next PRINT", async () => {
  expect(await screen().count()).toBe(0);
  await command(page, "FP,hides.sbp");
  await screen().waitFor();
  await page.getByRole("dialog").getByRole("button", { name: "OK" }).click();
  await screen().waitFor({ state: "detached" });
  await ready();
  await run("FP,again.sbp");
  await screen().waitFor();
  await run("VD,,,,,,,0");
  await screen().waitFor({ state: "detached" });
});

it("sbp_io_print_suppress: VD between the moves of a file closes it for good", async () => {
  expect(await screen().count()).toBe(0);
  await command(page, "FP,moves.sbp");
  await screen().waitFor();
  await screen().waitFor({ state: "detached" });
  await ready();
  expect(await screen().count()).toBe(0);
});

it("sbp_cmd_sf: what has to be given is marked, OK sends what holds, Enter is OK", async () => {
  await run("SF,1");
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "always"));
  await page.reload();
  await arm(page);
  await line().pressSequentially("sf");
  const sheet = page.getByRole("dialog", { name: /^SF / });
  await sheet.locator(".field-required").waitFor();
  expect(await sheet.locator(".sheet-line").textContent()).toBe("SF,1");
  await page.keyboard.press("Enter");
  await sheet.waitFor({ state: "detached" });
  await until(async () => (await stateOf(workshop)).job?.command === "SF,1", "SF,1 is sent");
  await ready();
  await line().pressSequentially("sc");
  await page.getByRole("dialog", { name: /^SC / }).locator(".field-required").waitFor();
  await page.keyboard.press("Escape");
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "never"));
  await page.reload();
  await arm(page);
});

it("sbp_val_vd_comments: with it on, comments of a file are listed beside what it prints", async () => {
  await run("VD,,,,,,,1");
  await run("FP,words.sbp");
  await screen().waitFor();
  const words = await screen().locator("pre").textContent();
  expect(words).toContain("alpha");
  expect(words).toContain("beta");
  await run("VD,,,,,,,0");
});

it("sbp_val_vd_msgscreen: place and size are those of VD in twips, and moving it keeps them", async () => {
  await run("VD,,,,,,,,,,,,1440,1080,7200,3600");
  await run("FP,hello.sbp");
  await screen().waitFor();
  const box = await screen().boundingBox();
  const strip = (await page.locator(".body").boundingBox())?.y ?? 0;
  expect(box).toEqual({ x: 96, y: strip + 72, width: 480, height: 240 });
  await page.mouse.move(200, strip + 82);
  await page.mouse.down();
  await page.mouse.move(250, strip + 112, { steps: 4 });
  await page.mouse.up();
  const window = async () => {
    const values = await (await fetch(`${workshop.address}/api/values`)).json();
    const { settings } = values as { settings: string[] };
    return settings
      .find((text) => text.startsWith("VD,"))
      ?.split(",")
      .slice(12, 16);
  };
  await expect.poll(window).toEqual(["2190", "1530", "7200", "3600"]);
  await ready();
  await page.getByRole("button", { name: "Close the message screen" }).click();
});

it("sbp_lang_line_display: the files that run are listed, each with its line", async () => {
  await command(page, "FP,outer.sbp");
  const calls = page.getByRole("list", { name: "Files that run" }).getByRole("listitem");
  await calls.filter({ hasText: /inner\.sbp line \d/ }).waitFor();
  expect((await calls.allTextContents()).join(" ")).toMatch(
    /outer\.sbp line \d+.*inner\.sbp line \d+/,
  );
  await ready();
});

it("sbp_val_vd_display: the face follows VD", async () => {
  await run("VD,,,,,,,,,,,,,,,,,,1");
  await run("VD,,,,,,,,,,,,,,,,,,0");
  await line().waitFor();
  await command(page, "VD,,,,,,,,,,,,,,,,,,1");
  await page.getByRole("navigation", { name: "EASY" }).waitFor();
  await page.getByRole("radio", { name: "FULL" }).click();
});

it("sbp_cmd_z_confirm: a zero asks first in EASY, typed it acts at once", async () => {
  await run("MX,3");
  await page.getByRole("radio", { name: "EASY" }).click();
  await page.getByRole("button", { name: "Zero X", exact: true }).click();
  const sheet = page.getByRole("dialog", { name: "Zero X?" });
  await sheet.getByRole("button", { name: "Cancel" }).click();
  expect(await location(page, "X")).toBe(3);
  await page.getByRole("button", { name: "Zero X", exact: true }).click();
  await sheet.getByRole("button", { name: "Zero X" }).click();
  await until(async () => (await location(page, "X")) === 0, "X is zero");
  await ready();
  await page.getByRole("radio", { name: "FULL" }).click();
  await run("MX,2");
  await line().pressSequentially("zx");
  await until(async () => (await location(page, "X")) === 0, "X is zero again");
  await ready();
});

it("sbp_cmd_sa: the toggle shows absolute distances, and SA takes them", async () => {
  await run("MX,3");
  await line().pressSequentially("sa");
  await until(async () => {
    const { job } = await stateOf(workshop);
    return job?.command?.toLowerCase() === "sa" && job.ended !== null;
  }, "SA is carried out");
  await ready();
  expect(await page.getByRole("radio", { name: "Absolute" }).isChecked()).toBe(true);
  await run("M2,3,7");
  await expect.poll(() => location(page, "X")).toBe(3);
  await expect.poll(() => location(page, "Y")).toBe(7);
  const values = (await (await fetch(`${workshop.address}/api/values`)).json()) as {
    system: { number: number; value: string }[];
  };
  expect(values.system.find(({ number }) => number === 21)?.value).toBe("0");
});

it("sbp_cmd_sa_sr_default: a session starts absolute, and the toggle is clicked", async () => {
  expect(await page.getByRole("radio", { name: "Absolute" }).isChecked()).toBe(true);
  await page.getByRole("radio", { name: "Relative" }).click();
  await until(async () => !(await stateOf(workshop)).units.absolute, "relative");
  await ready();
  await page.getByRole("radio", { name: "Absolute" }).click();
  await until(async () => (await stateOf(workshop)).units.absolute, "absolute");
  await ready();
});

it("sbp_con_status_panel__switched: modes and speeds are switched from the screen", async () => {
  await page.getByRole("button", { name: "SIMULATED" }).click();
  await page.getByRole("button", { name: "PREVIEW" }).waitFor();
  await page.getByRole("button", { name: "PREVIEW" }).click();
  await page.getByRole("button", { name: "SIMULATED" }).waitFor();
  await ready();
  await page.getByRole("button", { name: "Move", exact: true }).first().click();
  const sheet = page.getByRole("dialog", { name: /MS/ });
  await sheet.getByRole("textbox").first().fill("1.25");
  await sheet.getByRole("button", { name: "OK" }).click();
  await page.locator(".status-speeds td", { hasText: "1.25" }).waitFor();
  await ready();
});

it("sbp_con_fillin_order: the sheet of CC shows the feature last, the line keeps its place", async () => {
  await line().pressSequentially("cc");
  await page.getByRole("button", { name: "Fill-in sheet" }).click();
  const sheet = page.getByRole("dialog", { name: /CC/ });
  await sheet.getByLabel("Feature").waitFor();
  const names = await sheet.locator(".sheet-fields .field-label").allTextContents();
  expect(names.at(-1)).toContain("Feature");
  expect(names.at(-2)).not.toContain("No pull-up");
  await sheet.getByLabel("Diameter").fill("4");
  await sheet.getByLabel("Feature").fill("1");
  expect(await sheet.locator(".sheet-line").textContent()).toMatch(
    /^CC,4,[^,]*,[^,]*,,,[^,]*,[^,]*,[^,]*,[^,]*,1$/,
  );
  await page.keyboard.press("Escape");
});

it("sbp_val_vd_axes: VD shows as many axes as there are", async () => {
  await run("VD,,5");
  await until(async () => (await page.locator("[data-axis]").count()) === 5, "five axes");
  expect(
    await page
      .locator("[data-axis]")
      .evaluateAll((all) => all.map((one) => one.getAttribute("data-axis"))),
  ).toEqual(["X", "Y", "Z", "A", "B"]);
});

it("sbp_con_keypad_alt: Alt makes PgUp and PgDn move the accessory axis", async () => {
  const [a, z] = [await location(page, "A"), await location(page, "Z")];
  await line().press("k");
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  const hand = keysOf(page, ["Alt", "PageUp"]);
  await hold(workshop, hand, ({ motion }) => motion.at.working[3] > a, "A moves");
  await hand.up();
  await until(async () => (await stateOf(workshop)).machine.state === "asking", "it stands");
  expect(await location(page, "Z")).toBe(z);
  await page.keyboard.press("Escape");
  await ready();
  await run("VD,,3");
});

it("sbp_con_keypad_record__recorder: places that are kept are in the recorder's list", async () => {
  await run("M2,3,4");
  await line().press("k");
  await page.getByRole("dialog", { name: "Keypad" }).waitFor();
  await page.keyboard.press("#");
  await page.keyboard.press("2");
  await page.keyboard.press("Escape");
  await until(async () => (await stateOf(workshop)).recorder.lines.at(-1) === "J2,3,4", "recorded");
  await ready();
});

it("sbp_cmd_sp_space: in preview the space bar leads to the large picture and back", async () => {
  await line().pressSequentially("sp");
  await page.getByRole("button", { name: "PREVIEW" }).waitFor();
  await ready();
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press("Space");
  await page.locator(".path-large").waitFor();
  await page.keyboard.press("Space");
  await page.locator(".path-large").waitFor({ state: "detached" });
  await line().pressSequentially("sm");
  await page.getByRole("button", { name: "SIMULATED" }).waitFor();
  await ready();
});
