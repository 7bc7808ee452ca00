/** Rows of the ledger about what the page shows, lists and makes: UV, UD, TU, FS, VP, MO, custom cuts. */

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { type Pixel, painted } from "./pixels";
import {
  arm,
  carryOut,
  command,
  commandDesk,
  kerf,
  location,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

const shots = process.env.KERF_SHOTS;
let workshop: Workshop;
let page: Page;

const files: Record<string, string> = {
  "proj1.sbp": "MX,1\n",
  "proj12.sbp": "MX,1\n",
  "project.sbp": "MX,1\n",
  "readme.txt": "Not a part.\n",
  "jogs.sbp": "J2,10,5\nMZ,-.1\nM2,20,5\nJZ,.5\nJ2,10,10\n",
  "fails.sbp": "GOTO NOWHERE\n",
  "first.sbp": "C#,90\nMX,1\n",
  "ninety.sbp": "CN,90\nMY,1\n",
  "six.sbp": "C6\nMX,2\n",
  "none.sbp": "C8\nMX,9\n",
};

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 50 });
  mkdirSync(join(workshop.parts, "custom"));
  for (const [name, text] of Object.entries(files)) writeFileSync(join(workshop.parts, name), text);
  page = await commandDesk(workshop);
  await arm(page);
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  await page.getByLabel("Command line").fill("");
});

const run = (line: string) => carryOut(workshop, page, line);
const shot = async (name: string) => {
  if (shots) await page.screenshot({ path: `${shots}/${name}.png` });
};
const idle = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "the machine is idle");
const closed = async () => {
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
};
const values = () => page.getByRole("dialog", { name: "Values" });
const row = (name: string | RegExp) => values().getByRole("row", { name });
const typed = (...args: string[]) =>
  execFileSync(kerf, [...args, "--parts", workshop.parts, "--data", workshop.parts]).toString();

it("sbp_cmd_uv: every V command as a line, its values with names and units, and the part folder", async () => {
  await run("VS,3,1.5");
  await command(page, "UV");
  await row(/^VS 1:/).waitFor();
  await shot("uv");
  const told = typed("settings", "show").trim().split("\n");
  for (const letters of ["VD", "VB", "VC", "VI", "VL", "VN", "VH", "VP", "VR", "VS", "VU"]) {
    const line = told.find((one) => one.startsWith(`${letters},`));
    const heads = values().getByRole("rowheader", { name: line ?? "missing", exact: true });
    expect(await heads.count(), `${letters}: ${line}`).toBe(1);
  }
  expect(await row(/^VS 1:/).textContent()).toMatch(/3in\/s$/);
  expect(await row(/^VS 2:/).textContent()).toMatch(/1\.5in\/s$/);
  expect(await row(/^VC 1:/).textContent()).toMatch(/0\.25in$/);
  expect(await row(/Part folder/).textContent()).toContain(workshop.parts);
  await closed();
  await run("VD,,,1");
  await command(page, "UV");
  await row(/^VS 1:/).waitFor();
  await expect.poll(() => row(/^VS 1:/).textContent()).toMatch(/76\.2mm\/s$/);
  await closed();
  await run("VD,,,0");
});

it("sbp_cmd_ud: driver, port, firmware, inputs, outputs, uValue, the last error; all is kept with UV", async () => {
  await command(page, "FP,fails.sbp");
  await page.getByText("NOWHERE").first().waitFor();
  await idle();
  const said = await fetch(`${workshop.address}/api/registry/uValue`, {
    method: "PUT",
    body: "seven",
  });
  expect(said.status).toBe(200);
  await run("SO,3,1");
  await command(page, "UD");
  await row(/^software/).waitFor();
  const expected: [string, RegExp][] = [
    ["driver", /simulated machine/],
    ["firmware", /\d/],
    ["port", /1/],
    ["inputs on", /none|\d/],
    ["outputs on", /3/],
    ["uValue", /seven/],
    ["last error", /fails\.sbp:1:/],
  ];
  for (const [name, value] of expected)
    await expect.poll(() => row(new RegExp(`^${name} `)).textContent()).toMatch(value);
  await shot("ud");
  const kept = () => readFileSync(join(workshop.parts, "problem.log"), "utf8");
  await expect.poll(kept).toMatch(/uValue: seven\n.*outputs on: 3\n.*\nVS,3,1\.5,/s);
  // What went wrong before is still in it.
  expect(kept()).toMatch(/error: .*NOWHERE/);
  await closed();
  await idle();
  await run("SO,3,0");
});

it("sbp_file_fs_mask: the mask of FS decides which files the dialog lists", async () => {
  const listed = async () => {
    await page.keyboard.press("Control+o");
    await page.getByRole("option", { name: "proj12.sbp" }).waitFor();
    const names = await page.getByRole("option").locator("b, .file-name").allTextContents();
    const found = names.length > 0 ? names : await page.getByRole("option").allTextContents();
    const listed = Object.keys(files).filter((name) => found.some((one) => one.startsWith(name)));
    await closed();
    return listed.filter((name) => /^(proj|readme)/.test(name));
  };
  expect(await listed()).toEqual(["proj1.sbp", "proj12.sbp", "project.sbp"]);
  await run("FS,,*.*");
  expect(await listed()).toEqual(["proj1.sbp", "proj12.sbp", "project.sbp", "readme.txt"]);
  await run("FS,,proj??.sbp");
  expect(await listed()).toEqual(["proj12.sbp"]);
  await run("FS,,*.sb?");
});

const isRed = ([r, g, b]: Pixel): boolean => r > 150 && g < 110 && b < 110;
const red = async () => (await painted(page, page.locator(".path-box"))).count(isRed);

it("sbp_val_vp_jogs: jogs are red, and with 0 they are left out of the picture", async () => {
  await script(workshop, "open", { name: "jogs.sbp" });
  await page.locator('[data-path="all"]').waitFor();
  await expect.poll(red).toBeGreaterThan(50);
  await shot("jogs");
  await run("VP,,,,,,,,0");
  await expect.poll(red).toBe(0);
  await shot("no-jogs");
  await run("VP,,,,,,,,1");
  await expect.poll(red).toBeGreaterThan(50);
});

it("sbp_cmd_mo_handmove: the words at MO in its menu, and its help, warn of pushing by hand", async () => {
  const menus = page.getByRole("navigation", { name: "Commands" });
  await menus.getByRole("button", { name: "Move", exact: true }).click();
  const entry = page.getByRole("menuitem", { name: /^MO/ });
  await entry.hover();
  const words = await entry.locator("[title]").getAttribute("title");
  await shot("mo");
  for (const word of [/by hand/, /loses its position/, /voltage/]) expect(words).toMatch(word);
  await page.keyboard.press("Escape");
  await command(page, "HC");
  await page.getByLabel("Look for").fill("MO");
  await page
    .getByText(/by hand afterwards loses its position .* voltage/)
    .first()
    .waitFor();
  await shot("mo-help");
  await page.getByRole("link", { name: "Operate" }).click();
  await page.getByLabel("Command line").waitFor();
});

it("sbp_ext_custom_cuts: C# and CN run the variables, C6 the spindle; a missing one is told", async () => {
  await run("J2,0,0");
  writeFileSync(join(workshop.parts, "custom", "Custom90.sbc"), "MZ,.75\n");
  for (const file of ["first.sbp", "ninety.sbp"]) {
    await run("JZ,0");
    await run(`FP,${file}`);
    await expect.poll(() => location(page, "Z")).toBe(0.75);
  }
  // Kerf's own: it turns the spindle on, which asks.
  await command(page, "FP,six.sbp");
  const spindle = page.locator(".question-text", { hasText: "The spindle is about to start." });
  await spindle.waitFor();
  await shot("six");
  await page.getByRole("dialog").getByRole("button", { name: "OK", exact: true }).click();
  await expect.poll(() => location(page, "X")).toBe(2);
  await idle();
  await command(page, "FP,none.sbp");
  await page.locator(".word-error", { hasText: "Custom8.sbc" }).first().waitFor();
  await idle();
  expect(await location(page, "X")).toBe(2);
});

it("sbp_tool_tu: a form makes the file, warns to level Z, shows it; cut, the table is flat at the depth", async () => {
  await page
    .getByRole("navigation", { name: "Commands" })
    .getByRole("button", { name: "Tools" })
    .click();
  await page.getByRole("menuitem", { name: /^TU/ }).click();
  const sheet = page.getByRole("dialog", { name: /^TU/ });
  const fill = (name: string, value: string) =>
    sheet.getByRole("textbox", { name: new RegExp(`^${name}`) }).fill(value);
  await fill("Area, X", "10");
  await fill("Area, Y", "6");
  await fill("Bit diameter", "2");
  await fill("Depth", ".1");
  await fill("Overlap", "20");
  await shot("tu");
  await sheet.getByRole("button", { name: "OK", exact: true }).click();
  await page.getByText("Level the Z axis before this file is run.").first().waitFor();
  await until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === "surface.sbp" && opened.preview.state === "ready";
  }, "it is previewed");
  expect(readFileSync(join(workshop.parts, "surface.sbp"), "utf8")).toContain("CR");
  await page.locator('[data-path="all"]').waitFor();
  // What is planed, as the page cuts it out of its stock.
  await page.getByRole("button", { name: "Stock", exact: true }).click();
  await page.getByRole("slider", { name: "Planned time" }).focus();
  await page.keyboard.press("End");
  const bared = async () =>
    ((await page.locator(".path-lines").getAttribute("data-bared")) ?? "")
      .split(" ")
      .map((mm) => Number(mm) / 25.4);
  await until(async () => (await bared()).length === 3, "all is cut");
  await shot("surface");
  const [area = 0, wide = 0, deep = 0] = await bared();
  expect([wide, deep]).toEqual([expect.closeTo(10, 1), expect.closeTo(6, 1)]);
  // Nothing is left standing but the corners, which a round cutter leaves.
  expect(area / 25.4 / 60).toBeGreaterThan(0.97);
  const facts = await page.getByLabel("Extents and time").textContent();
  expect(facts).toContain("-0.100");
});

it("nothing went wrong on the page", () => {
  expect(workshop.mistakes).toEqual([]);
});
