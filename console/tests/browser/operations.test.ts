/** Every operation of the drawing's table through its sheet. */

import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { drawingWords } from "../../src/app/drawingWords";
import { labelsOf } from "../../src/draw/operations/form";
import type { OperationEntry, OperationPart } from "../../src/wire/messages";
import { openWorkshop, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ parts: ["10-from-a-drawing/from-a-drawing.rsg"], rate: 100 });
  page = await workshop.page();
  await page.goto(`${workshop.address}/draw`);
});
afterAll(() => workshop?.close());

const draw = async (op: object) => {
  const answer = await page.request.post(`${workshop.address}/api/do/draw`, { data: { op } });
  expect(await answer.text()).toContain('"problem":null');
};

/** Two closed shapes, one of them within the other, and two open ones whose ends are near. */
const shapes =
  "rect 0,0 100,100; circle 50,50 20; line 0,200 50,200; line 50.05,200 100,200; " +
  "select 1; group red; select 2; group blue";

/** Selection before an operation, where it is not everything closed. */
const selected: Record<string, string> = { join: "3,4", trim: "3", start: "1" };

/** Entries of an operation, where the usual will not do. */
const special: Record<string, Record<string, string>> = {
  trim: { Place: "10mm,200mm" },
  radius: { Radius: "60mm" },
  line: { Vertices: "0,0", "Vertices 2": "10,0 20,5" },
  "delete-vertices": { Place: "0,0" },
  justify: { Bottom: "-10" },
  sequence: { Shapes: "2,1,3,4", Layers: "black,blue,red", Level: "4,3" },
  pick: { Layers: "red", Remove: "2" },
  stretch: { Place: "-10mm,-10mm" },
  "load-clipboard": { File: "from-a-drawing.rsg" },
  set: { Height: "-3mm", Pass: "1mm", Tool: "2", Cut: "1", Offset: "3mm", Tag: "1mm" },
  comment: { Words: "Anna | 18 mm birch" },
  fillet: { Radius: "5mm" },
  chamfer: { Length: "5mm" },
  offset: { Distance: "2mm" },
  engrave: { Tool: "5mm", Depth: "2mm", Overlap: "0.5mm" },
  pocket: { Tool: "5mm", Depth: "2mm", Overlap: "0.5mm", Finish: "0.2mm" },
};

/** Done before an operation that needs more than shapes. */
const before: Record<string, string> = {
  paste: "clip",
  "clear-clipboard": "clip",
  pick: "pick 2",
  sequence: "pick 2",
  trim: "line 25,190 25,210; select 5",
  engrave: "directions auto; select 1,2",
  pocket: "directions auto; select 1,2",
};

/** Something that may be entered; places differ from part to part. */
function usual({ value }: OperationPart, n: number): string {
  switch (value?.is) {
    case "pair":
    case "vertex":
      return `${10 + 20 * n}mm,${5 + 15 * n}mm`;
    case "triple":
      return `${10 + 20 * n}mm,5mm,-3mm`;
    case "length":
      return "20mm";
    case "number":
      return "2";
    case "arc":
      return "2mm,90";
    case "grid":
      return "2x3";
    case "wordsOr":
      return value.words[0] ?? "";
    case "text":
      return "straight";
    default:
      return "";
  }
}

/** Opens the sheet of an operation, with one of its ways to say it. */
async function open({ name }: OperationEntry, variant: number, ways: number): Promise<void> {
  const title = drawingWords(name.replaceAll("-", " "));
  await page.getByRole("button", { name: "All operations…" }).click();
  await page.getByLabel("Find").fill(name);
  const exactly = new RegExp(`^${title}$`, "i");
  const has = page.locator("b", { hasText: exactly });
  await page.locator(".operation-list button", { has }).click();
  await page.getByRole("dialog", { name: exactly }).waitFor();
  if (ways > 1) await page.getByLabel("How", { exact: true }).selectOption(String(variant));
}

async function fill(name: string, parts: readonly OperationPart[]): Promise<void> {
  const sheet = page.getByRole("dialog");
  for (const [n, label] of labelsOf(parts).entries()) {
    const part = parts[n];
    if (!part?.value || part.value.is === "words" || part.value.is === "group") continue;
    const field = sheet.getByRole("textbox", { name: new RegExp(`^${label}\\W*$`) });
    const text = special[name]?.[label] ?? usual(part, n);
    if (text !== "") await field.fill(text);
  }
}

/** Waits until the sheet is closed, or tells why it is not. */
async function outcome(): Promise<string[]> {
  const sheet = page.getByRole("dialog");
  const words = sheet.locator(".operation-refused li, .field-error");
  const done = sheet.locator(".operation-done");
  const over = async () =>
    (await sheet.count()) === 0 || (await done.count()) > 0 || (await words.count()) > 0;
  await expect.poll(over).toBe(true);
  const told = await words.allTextContents();
  if ((await sheet.count()) > 0) await page.keyboard.press("Escape");
  return told;
}

it("opens and applies every operation of the table, in each way to say it", async () => {
  const answer = await page.request.get(`${workshop.address}/api/drawing/operations`);
  const table: OperationEntry[] = await answer.json();
  expect(table.length).toBeGreaterThan(40);
  const refused: string[] = [];
  for (const entry of table) {
    for (const [n, { parts, form }] of entry.variants.entries()) {
      await draw({ op: "new" });
      await draw({ op: "do", clauses: shapes });
      await draw({ op: "do", clauses: `select ${selected[entry.name] ?? "1,2"}` });
      if (before[entry.name]) await draw({ op: "do", clauses: before[entry.name] });
      await open(entry, n, entry.variants.length);
      await fill(entry.name, parts);
      await page.getByRole("button", { name: "Apply" }).click();
      const told = await outcome();
      if (told.length > 0) refused.push(`${form}: ${told.join("; ")}`);
    }
  }
  expect(refused).toEqual([]);
  expect(workshop.mistakes).toEqual([]);
}, 400_000);
