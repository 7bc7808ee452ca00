/** Faults of a shop: a full disk, two people at one drawing, a file that another program changes meanwhile. */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, expect, it } from "vitest";
import { edit, text, type } from "./editing";
import { openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
afterEach(() => workshop?.close());

const put = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
const read = (name: string) => readFileSync(join(workshop.parts, name), "utf8");
const drawing = async () => (await stateOf(workshop)).drawing;

async function drawPage(): Promise<Page> {
  const page = await workshop.page();
  await page.getByRole("link", { name: "Draw" }).click();
  await page.getByRole("application").waitFor();
  return page;
}

/** Draws with the mouse between two places of the sheet, parts of its width and height. */
async function drawn(page: Page, tool: string, ...places: [number, number][]): Promise<void> {
  await page.getByRole("button", { name: tool, exact: true }).click();
  const box = await page.getByRole("application").boundingBox();
  if (!box) throw new Error("there is no sheet");
  for (const [right, down] of places)
    await page.mouse.click(box.x + right * box.width, box.y + down * box.height);
}

it("two browsers have one drawing: what one draws the other sees, draws on, and takes back", async () => {
  workshop = await openWorkshop();
  const [desk, other] = [await drawPage(), await drawPage()];
  const shows = (count: number) =>
    Promise.all(
      [desk, other].map((page) =>
        page.getByRole("button", { name: `List ${count}`, exact: true }).waitFor(),
      ),
    );
  await drawn(desk, "Circle", [0.5, 0.5], [0.6, 0.5]);
  await shows(1);
  await drawn(other, "Rectangle", [0.2, 0.3], [0.4, 0.6]);
  await shows(2);
  await desk.keyboard.press("Escape");
  await other.keyboard.press("Escape");
  await other.getByRole("button", { name: "Undo", exact: true }).click();
  await shows(1);
  await other.getByRole("button", { name: "Undo", exact: true }).click();
  await until(async () => (await drawing())?.shapes === 0, "it is taken back");
  await desk.getByRole("button", { name: "Redo", exact: true }).click();
  await shows(1);
});

it("a full disk is told where something is to be written, and what lies there stays whole", async () => {
  workshop = await openWorkshop({ mostKilobytes: 900 });
  put("a.sbp", "MX,1\n");
  const page = await workshop.page();
  await page.keyboard.press("Control+o");
  const upload = async (name: string, bytes: number) => {
    const chooser = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: "Upload…" }).click();
    const buffer = Buffer.from("MX,1\n".repeat(bytes / 5));
    await (await chooser).setFiles([{ name, mimeType: "", buffer }]);
  };
  await upload("long.sbp", 2_000_000);
  await page.getByRole("list", { name: "Uploads" }).getByText("the disk is full").waitFor();
  await page.keyboard.press("Escape");
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await until(async () => read("a.sbp") === "MX,1\nMX,2\n", "what has room is saved");
});

it("a disk that is full when the editor saves is told, and what was typed is kept", async () => {
  workshop = await openWorkshop({ mostKilobytes: 900 });
  const before = "' nothing moves\n".repeat(57_000);
  put("long.sbp", before);
  const page = await workshop.page();
  await edit(page, "long.sbp");
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.insertText("' typed by hand\n".repeat(1000));
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.locator(".notice", { hasText: "the disk is full" }).waitFor();
  expect(read("long.sbp")).toBe(before);
  await page.reload();
  await page.locator(".cm-line", { hasText: "typed by hand" }).first().waitFor();
  expect(read("long.sbp")).toBe(before);
});

it("a program that is changed on the disk does not run before somebody has opened it again", async () => {
  workshop = await openWorkshop({ rate: 100 });
  put("a.sbp", "MX,1\nEND\n");
  const page = await workshop.page();
  const open = async () => {
    await script(workshop, "open", { name: "a.sbp" });
    await until(
      async () => (await stateOf(workshop)).opened?.preview.state === "ready",
      "it is previewed",
    );
  };
  await open();
  put("a.sbp", "MX,3\nEND\n");
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.locator(".notice", { hasText: "was changed since it was previewed" }).waitFor();
  expect((await stateOf(workshop)).job).toBeNull();
  await open();
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it has run");
  expect((await stateOf(workshop)).motion.at.working[0]).toBeCloseTo(76.2, 3);
});

it("a drawing that is changed on the disk is not written over without a question", async () => {
  workshop = await openWorkshop();
  const page = await drawPage();
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 0,0 10" } });
  await script(workshop, "draw", { op: { op: "save", name: "door.rsg", replaces: null } });
  await until(async () => (await drawing())?.changed === false, "it is saved");
  put("door.rsg", "another program was here");
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 50,0 10" } });
  await page.getByRole("button", { name: "Save…" }).click();
  await page.getByRole("button", { name: "Write" }).click();
  const asked = page.getByRole("dialog", { name: "Replace door.rsg?" });
  await asked.waitFor();
  await asked.getByRole("button", { name: "Cancel" }).click();
  expect(read("door.rsg")).toBe("another program was here");
});

it("text that is changed on the disk meanwhile is told while it stands in the editor", async () => {
  workshop = await openWorkshop();
  put("a.sbp", "MX,1\n");
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "MX,2");
  put("a.sbp", "MX,77\n");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("dialog", { name: "Replace a.sbp?" }).waitFor();
  await page.getByRole("button", { name: "Cancel" }).click();
  expect(read("a.sbp")).toBe("MX,77\n");
  expect(await text(page)).toContain("MX,2");
});
