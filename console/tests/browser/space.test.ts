/** The space bar is STOP on every screen, whatever has the focus; a field of text says that it is none. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, fullFace, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;
/** Every act that the page asked for, but those of its link. */
const asked: string[] = [];

beforeAll(async () => {
  workshop = await openWorkshop();
  writeFileSync(
    join(workshop.parts, "input.sbp"),
    'INPUT "How far" &far\nMSGBOX(Go on?, YesNo)\nEND\n',
  );
  page = await workshop.browser.newPage({ viewport: { width: 1280, height: 800 } });
  // What only stops is sent on its own way too: once is enough here.
  page.on("websocket", (socket) =>
    socket.on("framesent", ({ payload }) => {
      if (!socket.url().endsWith("/ws")) return;
      const { act } = JSON.parse(String(payload)) as { act: { do: string } };
      if (act.do !== "ping") asked.push(act.do);
    }),
  );
  await page.goto(workshop.address);
  await page.locator(".state", { hasText: /Disarmed|Ready/ }).waitFor();
});
afterAll(() => workshop?.close());

const focusable =
  "button, a[href], select, input, textarea, canvas, summary, [tabindex], [contenteditable=true]";

/** Gives the focus to one after the other; what it is, or nothing when there are no more. */
const focusOn = (n: number): Promise<{ name: string; writes: boolean } | null> =>
  page.evaluate(
    async ([all, at]) => {
      const seen = [...document.querySelectorAll<HTMLElement>(String(all))].filter(
        (one) => one.checkVisibility() && !one.closest("[inert]") && !one.matches(":disabled"),
      );
      const one = seen[Number(at)];
      if (!one) return null;
      one.focus();
      // A list may give the focus on to the field that it belongs to.
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      const here = document.activeElement;
      const box =
        here instanceof HTMLInputElement &&
        !["checkbox", "radio", "range", "file"].includes(here.type);
      const writes =
        box ||
        here instanceof HTMLTextAreaElement ||
        (here instanceof HTMLElement && here.isContentEditable);
      const name = `${one.tagName} ${one.getAttribute("aria-label") ?? one.textContent ?? ""}`;
      return { name: name.slice(0, 60), writes };
    },
    [focusable, n] as const,
  );

/** Presses the space bar at everything that can have the focus here; how many stopped and how many are written in. */
async function walk(where: string): Promise<{ stops: number; fields: number }> {
  const counted = { stops: 0, fields: 0 };
  for (let n = 0; ; n += 1) {
    const on = await focusOn(n);
    if (!on) return counted;
    const before = { at: page.url(), dialogs: await page.getByRole("dialog").count() };
    asked.length = 0;
    await page.keyboard.press("Space");
    const at = `${where}: ${on.name}`;
    const told = page.locator(".space-types");
    if (on.writes) {
      expect(asked, at).not.toContain("stop");
      await told.waitFor({ timeout: 5000 });
      expect(await told.getAttribute("title"), at).toContain("press Escape first");
      counted.fields += 1;
    } else {
      await expect
        .poll(() => asked, { message: `${at}: it stops, and is not pressed` })
        .toEqual(["stop"]);
      expect(await told.count(), at).toBe(0);
      counted.stops += 1;
    }
    expect({ at: page.url(), dialogs: await page.getByRole("dialog").count() }, at).toEqual(before);
  }
}

const route = (name: string) => () => page.getByRole("link", { name, exact: true }).click();
const key = (keys: string) => async () => {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press(keys);
};

const screens: readonly [string, () => Promise<void>, string][] = [
  ["operate", route("Operate"), ".state"],
  ["the FULL face", () => fullFace(page), ".command"],
  ["edit", route("Edit"), ".cm-content"],
  ["draw", route("Draw"), "canvas"],
  ["settings", route("Settings"), "main input:not([type=file])"],
  ["help", route("Help"), "main button"],
];

const sheets: readonly [string, () => Promise<void>][] = [
  ["files", key("Control+o")],
  ["palette", key("Control+k")],
  ["scratch pad", key("i")],
  ["calculator", key("F10")],
  ["values", key("Control+Shift+V")],
];

it.each(screens)("%s", async (where, go, there) => {
  await go();
  await page.locator(there).first().waitFor();
  const { stops } = await walk(where);
  expect(stops).toBeGreaterThan(8);
});

it.each(sheets)("the sheet %s", async (where, open) => {
  await route("Operate")();
  await fullFace(page);
  await open();
  await page.getByRole("dialog").waitFor();
  const { stops } = await walk(where);
  expect(stops).toBeGreaterThan(0);
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
});

it("stops with a key held beside it, and Escape leaves a field", async () => {
  await route("Operate")();
  await fullFace(page);
  const line = page.getByLabel("Command line");
  for (const leaves of [false, true]) {
    await line.focus();
    asked.length = 0;
    // Once forgets the space that was typed, once more leaves.
    for (let n = 0; leaves && n < 2; n += 1) await page.keyboard.press("Escape");
    // STOP says what the space bar is.
    await page.locator(".space-types").waitFor({ state: leaves ? "detached" : "visible" });
    await page.keyboard.press("Space");
    await expect.poll(() => asked).toEqual(leaves ? ["stop"] : []);
  }
  for (const beside of ["Control", "Alt", "Shift"]) {
    asked.length = 0;
    await page.keyboard.press(`${beside}+Space`);
    await expect.poll(() => asked, { message: beside }).toEqual(["stop"]);
  }
});

it("a field of a question is left by Escape, and a press of Enter is still one", async () => {
  await arm(page);
  await script(workshop, "open", { name: "input.sbp" });
  await page.locator(".job-name", { hasText: "input.sbp" }).waitFor();
  await until(
    async () => (await stateOf(workshop)).opened?.preview.state === "ready",
    "it is previewed",
  );
  const start = page.getByRole("button", { name: "Start" });
  await expect.poll(() => start.isEnabled()).toBe(true);
  await start.focus();
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog");
  const field = dialog.getByRole("textbox");
  await field.fill("2");
  await page.keyboard.press("Enter");
  await dialog.getByRole("button", { name: "Yes" }).waitFor();
  await page.keyboard.press("Space");
  await until(async () => (await stateOf(workshop)).machine.state === "idle", "STOP was heard");
  expect((await stateOf(workshop)).job?.ended).toBe("stopped");
});
