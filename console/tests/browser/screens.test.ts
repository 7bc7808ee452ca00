import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { act, openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ parts: ["01-first-cut/first-cut.sbp"], open: "first-cut.sbp" });
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  file("ask.sbp", "MSGBOX(Is it clamped?, YesNo)\nEND\n");
  file("input.sbp", 'INPUT "How deep" &d\nEND\n');
  file("edit.sbp", "FE,ask.sbp\nEND\n");
  page = await workshop.page();
  await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "never"));
});
afterAll(() => workshop?.close());

const themes = ["light", "dark", "contrast"];
const routes = ["/", "/edit", "/draw", "/settings", "/help"];

it.each(themes.flatMap((theme) => routes.map((route) => [theme, route] as const)))(
  "has nothing in anybody's way: %s %s",
  async (theme, route) => {
    await page.evaluate((chosen) => localStorage.setItem("kerf.theme", chosen), theme);
    await page.goto(`${workshop.address}${route}`);
    await page.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
    await page.locator(".state", { hasText: "Disarmed" }).waitFor();
    expect(await violations(page)).toEqual([]);
  },
);

/** Puts a theme on, as the settings do. */
const wear = (theme: string) =>
  page.evaluate((chosen) => document.documentElement.setAttribute("data-theme", chosen), theme);

const dialog = () => page.getByRole("dialog").first().waitFor();
const sheet = (action: string) => async () => {
  await act(page, action);
  await page.getByRole("dialog", { name: "Every action" }).waitFor({ state: "detached" });
  await dialog();
};
const fillIn = (line: string) => async () => {
  await page.getByLabel("Command line").fill(line);
  await page.getByRole("button", { name: "Fill-in sheet" }).click();
  await dialog();
};
const runs = (line: string) => async () => {
  await page.getByLabel("Command line").fill(line);
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).asked !== null, `${line} asks`);
  await page.locator("[role=dialog], .step").first().waitFor();
};
const drawn = (name: string) => async () => {
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name }).click();
  await dialog();
};

/** Everything that lies over a screen. */
const overlays: Record<string, () => Promise<void>> = {
  files: sheet("Open a file"),
  palette: async () => {
    await page.keyboard.press("Control+k");
    await dialog();
  },
  calculator: sheet("Calculator"),
  "scratch pad": sheet("Scratch pad"),
  values: sheet("Values and variables"),
  variables: async () => {
    await sheet("Values and variables")();
    await page.getByRole("button", { name: "Change or add…" }).click();
  },
  nudge: sheet("Nudge the workpiece"),
  recorder: sheet("Recorded commands"),
  inputs: sheet("Inputs of the machine"),
  ports: sheet("Ports of the card"),
  tools: sheet("Virtual tools"),
  "fill-in": fillIn("CC"),
  "fill-in of FP": fillIn("FP,first-cut.sbp"),
  "fill-in of VD": fillIn("VD"),
  "fill-in of a tool": fillIn("TD"),
  confirm: async () => {
    await page.getByRole("radio", { name: "EASY" }).click();
    await page.getByRole("button", { name: /^Zero X Y/ }).click();
    await dialog();
    await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
  },
  keypad: runs("SK"),
  "message box": runs("FP,ask.sbp"),
  input: runs("FP,input.sbp"),
  "line by line": runs("FG,first-cut.sbp"),
  editor: async () => {
    await runs("FP,edit.sbp")();
    await page.locator(".cm-content", { hasText: "MSGBOX" }).waitFor();
  },
  "save as": async () => {
    await page.getByRole("link", { name: "Edit" }).click();
    await page.getByRole("button", { name: "Save as…" }).click();
    await dialog();
  },
  "drawing to open": drawn("Open…"),
  "drawing to save": drawn("Save…"),
  "a question before a file is replaced": async () => {
    await page.getByRole("link", { name: "Edit" }).click();
    await page.getByRole("button", { name: "Save as…" }).click();
    await page.getByLabel("Name in the part folder").fill("input.sbp");
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: "Replace input.sbp?" }).waitFor();
  },
  "versions of a file": async () => {
    await sheet("Open a file")();
    await page.getByRole("radio", { name: "Versions…" }).click();
    await page.getByRole("option", { name: /ask\.sbp/ }).click();
    await page.getByRole("dialog", { name: "Versions of ask.sbp" }).waitFor();
  },
  operations: drawn("All operations…"),
  engraving: drawn("Engrave…"),
};

it.each(Object.entries(overlays))(
  "has nothing in anybody's way with this open: %s",
  async (_, open) => {
    await page.goto(workshop.address);
    const arm = page.getByRole("button", { name: "Arm", exact: true });
    await page.locator(".state", { hasText: /Disarmed|Ready/ }).waitFor();
    if ((await arm.count()) > 0) await arm.click();
    await page.locator(".state", { hasText: "Ready" }).waitFor();
    await open();
    const found: string[] = [];
    for (const theme of themes) {
      await wear(theme);
      found.push(...(await violations(page)).map((text) => `${theme}: ${text}`));
    }
    await script(workshop, "stop");
    await until(async () => (await stateOf(workshop)).machine.state === "idle", "it is over");
    expect(found).toEqual([]);
  },
);

it.each([
  [1280, 720],
  [1280, 800],
  [1024, 768],
])("shows the operator everything without scrolling at %d by %d", async (width, height) => {
  await page.setViewportSize({ width, height });
  for (const face of ["easy", "full"]) {
    await page.evaluate((chosen) => localStorage.setItem("kerf.face", chosen), face);
    await page.goto(workshop.address);
    await page.locator(".location-number").first().waitFor();
    const scrolls = await page.locator(".screen").evaluate((screen) => ({
      down: screen.scrollHeight - screen.clientHeight,
      across: document.documentElement.scrollWidth - innerWidth,
    }));
    expect(scrolls).toEqual({ down: 0, across: 0 });
  }
});

it("sbp_con_position: shows every axis with three decimals and its unit", async () => {
  await page.goto(workshop.address);
  for (const axis of ["X", "Y", "Z"]) {
    expect(await page.locator(`[data-axis="${axis}"]`).textContent()).toMatch(/^-?\d+\.\d{3}$/);
  }
  expect(await page.locator(".location-unit").first().textContent()).toBe("in");
});
