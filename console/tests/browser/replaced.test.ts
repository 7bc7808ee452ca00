/** No file is replaced without a question; what was replaced comes back. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { edit, text, type } from "./editing";
import { openWorkshop, script, stateOf, tabTo, until, type Workshop } from "./workshop";

let workshop: Workshop;

beforeEach(async () => {
  workshop = await openWorkshop({ rate: 100 });
});
afterEach(() => workshop?.close());

const old = "'By hand\nMX,1\nMX,2\n";

const put = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
const read = (name: string) => readFileSync(join(workshop.parts, name), "utf8");

/** A page with a circle on the sheet. */
async function drawn(): Promise<Page> {
  const page = await workshop.page();
  await page.getByRole("link", { name: "Draw" }).click();
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 0,0 10" } });
  await until(async () => (await stateOf(workshop)).drawing?.shapes === 1, "a circle is drawn");
  return page;
}

const question = (page: Page, name: string) =>
  page.getByRole("dialog", { name: `Replace ${name}?` });

/** Opens the sheet of a button and asks to write under a name. */
async function write(page: Page, button: string, name: string): Promise<void> {
  await page.getByRole("button", { name: button }).click();
  await page.getByLabel("Name").fill(name);
  await page.getByRole("button", { name: "Write" }).click();
}

it("asks before a drawing replaces a file, with the mouse", async () => {
  put("door.rsg", old);
  const page = await drawn();
  await write(page, "Save…", "door.rsg");
  const asked = question(page, "door.rsg");
  await asked.waitFor();
  const text = await asked.textContent();
  for (const words of ["a drawing", `${old.length} B`, "changed today", "20 versions"])
    expect(text).toContain(words);
  await asked.getByRole("button", { name: "Cancel" }).click();
  await asked.waitFor({ state: "detached" });
  expect(read("door.rsg")).toBe(old);
  expect((await stateOf(workshop)).drawing?.changed).toBe(true);

  await page.getByRole("button", { name: "Write" }).click();
  await asked.getByRole("button", { name: "Replace" }).click();
  await until(async () => (await stateOf(workshop)).drawing?.changed === false, "it is saved");
  expect(read("door.rsg")).not.toBe(old);

  // Saved once more it is the same file: nobody is asked.
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 50,0 10" } });
  await until(async () => (await stateOf(workshop)).drawing?.changed === true, "it is changed");
  await write(page, "Save…", "door.rsg");
  await until(async () => (await stateOf(workshop)).drawing?.changed === false, "it is saved");
  expect(workshop.mistakes.filter((told) => !told.includes("409"))).toEqual([]);
});

it("asks before a part program replaces a file, with the keyboard", async () => {
  put("drawing.sbp", old);
  const page = await drawn();
  await tabTo(page, "Make the part program…");
  await page.keyboard.press("Enter");
  await page.getByLabel("Name").waitFor();
  await page.keyboard.press("Enter");
  const asked = question(page, "drawing.sbp");
  await asked.waitFor();
  expect(await asked.textContent()).toContain("a part program of 3 lines");
  // Enter alone replaces nothing, and Esc does not either.
  await page.keyboard.press("Enter");
  await asked.waitFor({ state: "detached" });
  expect(read("drawing.sbp")).toBe(old);
  await tabTo(page, "Write");
  await page.keyboard.press("Enter");
  await asked.waitFor();
  await page.keyboard.press("Escape");
  await asked.waitFor({ state: "detached" });
  expect(read("drawing.sbp")).toBe(old);
  await tabTo(page, "Write");
  await page.keyboard.press("Enter");
  await asked.waitFor();
  await tabTo(page, "Replace");
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).opened?.name === "drawing.sbp", "it is open");
  expect(read("drawing.sbp")).not.toBe(old);
});

it("asks before text of the editor replaces another file, and keeps what it was", async () => {
  put("a.sbp", old);
  put("b.sbp", "MY,1\n");
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,3");
  await page.getByRole("button", { name: "Save as…" }).click();
  await page.getByLabel("Name in the part folder").fill("b.sbp");
  await page.keyboard.press("Enter");
  const asked = question(page, "b.sbp");
  await asked.waitFor();
  expect(await asked.textContent()).toContain("a part program of 1 line");
  await page.keyboard.press("Escape");
  await asked.waitFor({ state: "detached" });
  expect(read("b.sbp")).toBe("MY,1\n");
  await page.keyboard.press("Escape");

  // Its own file needs no question, until somebody else writes it.
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await until(async () => read("a.sbp").includes("MX,3"), "it is saved");
  await type(page, "MX,4");
  put("a.sbp", "MX,99\n");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  const again = question(page, "a.sbp");
  await again.getByRole("button", { name: "Cancel" }).click();
  expect(read("a.sbp")).toBe("MX,99\n");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await again.getByRole("button", { name: "Replace" }).click();
  await until(async () => read("a.sbp").includes("MX,4"), "it is saved");

  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("radio", { name: "Versions…" }).click();
  await page.getByRole("option", { name: /a\.sbp/ }).click();
  const versions = page.getByRole("dialog", { name: "Versions of a.sbp" });
  await versions.getByRole("listitem").nth(1).waitFor();
  expect(await versions.getByRole("listitem").count()).toBe(2);
  await versions.getByRole("button", { name: "Bring version 1 back" }).click();
  await until(async () => read("a.sbp") === old, "the first one is back");
  await until(async () => (await versions.getByRole("listitem").count()) === 3, "it is kept too");
  // The editor shows it, for nothing was typed meanwhile.
  await page.keyboard.press("Escape");
  await page.locator(".cm-content", { hasText: "By hand" }).waitFor();
  expect(await text(page)).not.toContain("MX,4");
});

it("pro_files_dxf_out: tells what a DXF has no place for, and the drawing stays unsaved", async () => {
  const page = await drawn();
  await script(workshop, "draw", { op: { op: "do", clauses: "select all; group red" } });
  await write(page, "Save…", "door.dxf");
  await page.getByText("door.dxf: layers and arrays will not be saved").first().waitFor();
  const listed = async () => {
    const answer = await page.request.get(`${workshop.address}/api/drawing/shapes`);
    return (await answer.json()).shapes as { group: string; points: number[] }[];
  };
  const saved = await listed();
  const { drawing } = await stateOf(workshop);
  expect([drawing?.changed, drawing?.name]).toEqual([true, null]);
  expect(read("door.dxf")).toContain("POLYLINE");
  expect(saved.map(({ group }) => group)).toContain("red");
  // Opened again it has the same shapes, all of them black, and no array.
  await script(workshop, "draw", { op: { op: "open", name: "door.dxf" } });
  await until(async () => (await stateOf(workshop)).drawing?.name === "door.dxf", "it is opened");
  const back = await listed();
  expect(back.map(({ group }) => group)).toEqual(saved.map(() => "black"));
  for (const [n, { points }] of back.entries())
    for (const [k, value] of points.entries())
      expect(value).toBeCloseTo(saved[n]?.points[k] ?? Number.NaN, 6);
});

it("saves tool paths as tool paths, never over their drawing", async () => {
  const page = await drawn();
  await write(page, "Save…", "plate.rsg");
  await until(async () => (await stateOf(workshop)).drawing?.name === "plate.rsg", "it is saved");
  await page.getByRole("button", { name: "Machine", exact: true }).click();
  await until(
    async () => (await stateOf(workshop)).opened?.name === "plate.rsm",
    "the job is made",
  );
  const drawing = read("plate.rsg");
  const job = read("plate.rsm");
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("button", { name: "plate.rsm", exact: true }).click();
  await page.getByText("These are tool paths").first().waitFor();
  await script(workshop, "draw", { op: { op: "do", clauses: "select all; move 5,0" } });
  await page.getByRole("button", { name: "Save…" }).click();
  await page.keyboard.press("Enter");
  await until(async () => (await stateOf(workshop)).drawing?.changed === false, "it is saved");
  expect(read("plate.rsg")).toBe(drawing);
  expect(read("plate.rsm")).not.toBe(job);
});
