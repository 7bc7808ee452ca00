/** Files of the part folder are brought to this computer, copied, renamed, deleted and brought back. */

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;

const cut = "SA\nM2,1,0\nM2,1,1\n";
const other = "SA\nMX,3\n";
const place = (name: string) => join(workshop.parts, name);
const read = (name: string) => readFileSync(place(name), "utf8");
const there = (name: string) => existsSync(place(name));

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  page = await workshop.page();
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  for (const [name, text] of [
    ["cut.sbp", cut],
    ["other.sbp", other],
    ["door.sbp", cut],
  ] as const)
    writeFileSync(place(name), text);
  for (let n = 0; n < 3 && (await page.getByRole("dialog").count()) > 0; n += 1)
    await page.keyboard.press("Escape");
  await page.keyboard.press("Control+o");
  await page.getByRole("dialog", { name: "Part folder" }).waitFor();
});

const button = (name: string) => page.getByRole("button", { name, exact: true });
const row = (name: RegExp) => page.getByRole("option", { name });

/** Chooses what becomes of a file, then the file. */
async function use(what: string, file: RegExp): Promise<void> {
  await page.getByRole("radio", { name: what, exact: true }).click();
  await row(file).click();
}

async function names(to: string): Promise<void> {
  await page.getByLabel("Name in the part folder").fill(to);
  await page.keyboard.press("Enter");
}

async function shot(name: string): Promise<void> {
  if (process.env.SHOTS) await page.screenshot({ path: `${process.env.SHOTS}/${name}.png` });
}

it("a file is downloaded byte for byte in two presses", async () => {
  const comes = page.waitForEvent("download");
  await use("Download", /cut\.sbp/);
  const download = await comes;
  expect(download.suggestedFilename()).toBe("cut.sbp");
  // A hidden file is in no list.
  await download.saveAs(place(".downloaded"));
  expect(read(".downloaded")).toBe(cut);
  await shot("files");
  expect(await violations(page)).toEqual([]);
});

it("a copy replaces nothing unless somebody says so", async () => {
  await use("Copy…", /cut\.sbp/);
  expect(await page.getByLabel("Name in the part folder").inputValue()).toBe("cut copy.sbp");
  await page.keyboard.press("Enter");
  await row(/cut copy\.sbp/).waitFor();
  expect(read("cut copy.sbp")).toBe(cut);
  await use("Copy…", /cut\.sbp/);
  await names("other.sbp");
  const asked = page.getByRole("dialog", { name: "Replace other.sbp?" });
  await asked.getByText("a part program of 2 lines").waitFor();
  await asked.getByRole("button", { name: "Cancel" }).click();
  await asked.waitFor({ state: "detached" });
  expect([read("other.sbp"), read("cut.sbp")]).toEqual([other, cut]);
  // That it was refused at first the browser tells its own log.
  workshop.mistakes.length = 0;
});

it("a file that is open is open under its new name", async () => {
  writeFileSync(place("cut.sbp.answers"), "2\n");
  await script(workshop, "open", { name: "cut.sbp" });
  await use("Rename…", /cut\.sbp/);
  await names("gate.sbp");
  await until(async () => (await stateOf(workshop)).opened?.name === "gate.sbp", "it is open");
  expect([there("cut.sbp.answers"), read("gate.sbp.answers")]).toEqual([false, "2\n"]);
  expect([there("cut.sbp"), read("gate.sbp")]).toEqual([false, cut]);
});

it("sample answers go with their file: under its new name, into the bin, and back", async () => {
  writeFileSync(place("door.sbp.answers"), "1: 3\n");
  await use("Rename…", /door\.sbp/);
  await names("gate2.sbp");
  await until(async () => there("gate2.sbp.answers"), "the answers have the new name");
  await until(async () => !there("door.sbp.answers"), "the answers have lost the old one");
  await use("Delete…", /^gate2\.sbp(?!\.)/);
  await button("Delete").click();
  await until(async () => !there("gate2.sbp.answers"), "the answers are in the bin");
  await button("Bin…").click();
  await button("Bring back gate2.sbp").click();
  await until(async () => there("gate2.sbp.answers"), "the answers are back");
  expect(read("gate2.sbp.answers")).toBe("1: 3\n");
});

it("a file that was opened before is opened again by one press, also after a reload", async () => {
  for (const name of ["cut.sbp", "other.sbp"]) await script(workshop, "open", { name });
  await until(async () => (await stateOf(workshop)).opened?.name === "other.sbp", "it is open");
  await page.reload();
  await page.locator(".job-name", { hasText: "other.sbp" }).waitFor();
  await page.keyboard.press("Control+o");
  const last = page.getByRole("region", { name: "Opened last" });
  await expect
    .poll(async () => (await last.getByRole("button").allTextContents()).slice(0, 2))
    .toEqual(["other.sbp", "cut.sbp"]);
  await last.getByRole("button", { name: "cut.sbp", exact: true }).click();
  await until(async () => (await stateOf(workshop)).opened?.name === "cut.sbp", "it is open");
});

it("what is deleted says what it is, lies in the bin, comes back, and goes when the bin is emptied", async () => {
  await use("Delete…", /other\.sbp/);
  const asked = page.getByRole("dialog", { name: "Delete other.sbp?" });
  await asked.getByText("a part program of 2 lines").waitFor();
  await shot("delete");
  await asked.getByRole("button", { name: "Cancel" }).click();
  expect(there("other.sbp")).toBe(true);
  for (const name of [/other\.sbp/, /door\.sbp/]) {
    await row(name).click();
    await button("Delete").click();
    await row(name).waitFor({ state: "detached" });
  }
  // Behind a question the list is nothing that a reader finds.
  await until(async () => !there("other.sbp") && !there("door.sbp"), "both are in the bin");
  await button("Bin…").click();
  await button("Bring back other.sbp").waitFor();
  await shot("bin");
  expect(await violations(page)).toEqual([]);
  await button("Bring back other.sbp").click();
  await until(async () => there("other.sbp"), "it is back");
  expect(read("other.sbp")).toBe(other);
  await button("Bring back other.sbp").waitFor({ state: "detached" });
  await button("Empty the bin…").click();
  await page.getByText("lost for good").waitFor();
  await button("Empty the bin").click();
  await page.getByText("Nothing was deleted.").waitFor();
  // A greyed button tells a hand that tries why it is greyed.
  await page.locator(".action-place", { has: button("Empty the bin…") }).click();
  await page.locator(".notice", { hasText: "The bin is empty." }).waitFor();
});

it("by keys alone: a file is chosen to be deleted, and is", async () => {
  await page.getByRole("radio", { name: "Delete…" }).focus();
  await page.keyboard.press("Enter");
  await row(/other\.sbp/).focus();
  await page.keyboard.press("Enter");
  await page.getByRole("dialog", { name: "Delete other.sbp?" }).waitFor();
  await button("Delete").focus();
  await page.keyboard.press("Enter");
  await until(async () => !there("other.sbp"), "it is gone");
  expect(workshop.mistakes).toEqual([]);
});

it("a file is looked for in all folders; a log is no program, and a mask shows it", async () => {
  mkdirSync(place("doors"), { recursive: true });
  writeFileSync(place("doors/hinge.sbp"), cut);
  writeFileSync(place("hinge.log"), "it ran");
  await page.getByLabel("Search").fill("hinge");
  await row(/doors\/hinge\.sbp/).waitFor();
  expect(await row(/hinge\.log/).count()).toBe(0);
  await page.getByLabel("Search").fill("*.log");
  await row(/hinge\.log/).waitFor();
  await page.getByLabel("Search").fill("hinge");
  await page.keyboard.press("Tab");
  await row(/doors\/hinge\.sbp/).click();
  await until(
    async () => (await stateOf(workshop)).opened?.name === "doors/hinge.sbp",
    "it is open",
  );
  await script(workshop, "folder", { name: "", mask: null });
});

const picture = async (name: string) =>
  (await fetch(`${workshop.address}/api/files/${name}?thumb`)).text();

it("a file that was previewed has a small picture", async () => {
  await script(workshop, "open", { name: "cut.sbp" });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+o");
  await expect.poll(() => picture("cut.sbp")).toContain("<path");
  expect(await picture("door.sbp")).not.toContain("<path");
  await row(/cut\.sbp/)
    .locator("img")
    .waitFor();
  await shot("thumbnails");
  expect(await violations(page)).toEqual([]);
});

it("a drawing is opened where it is drawn, and one that is not saved is not lost without a question", async () => {
  writeFileSync(place("plan.plt"), "IN;SP1;PU0,0;PD400,0;PD400,400;PU;");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+o");
  await row(/plan\.plt/).click();
  await page.locator(".drawing-name", { hasText: "plan" }).waitFor();
  expect((await stateOf(workshop)).drawing?.shapes).toBeGreaterThan(0);
  await script(workshop, "draw", { op: { op: "do", clauses: "circle 50,30 12" } });
  await page.keyboard.press("Control+o");
  await row(/plan\.plt/).click();
  await page.getByText("not saved: they are lost").waitFor();
  await page.getByRole("button", { name: "Cancel" }).click();
  expect((await stateOf(workshop)).drawing?.changed).toBe(true);
  await page.keyboard.press("Escape");
  await script(workshop, "draw", { op: { op: "new" } });
  await page.getByRole("link", { name: "Operate" }).click();
  await page.keyboard.press("Control+o");
});

it("a drawing has a small picture, where files are listed and where it was opened last", async () => {
  writeFileSync(place("frame.plt"), "IN;SP1;PU0,0;PD800,0,800,400,0,400,0,0;PU;");
  expect(await picture("frame.plt")).toContain("<path");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+o");
  await row(/frame\.plt/).click();
  await page.locator(".drawing-name", { hasText: "frame" }).waitFor();
  await page.getByRole("link", { name: "Operate" }).click();
  await script(workshop, "draw", { op: { op: "new" } });
  await page.keyboard.press("Control+o");
  const last = page.getByLabel("Opened last").getByRole("button", { name: "frame.plt" });
  const isDrawn = (image: SVGElement | HTMLElement) => (image as HTMLImageElement).complete;
  await expect.poll(() => last.locator("img").evaluate(isDrawn)).toBe(true);
  await shot("drawings");
  await last.click();
  await page.locator(".drawing-name", { hasText: "frame" }).waitFor();
  await page.getByRole("link", { name: "Operate" }).click();
  await page.keyboard.press("Control+o");
});

it("an earlier version is looked at before it is brought back", async () => {
  for (const text of ["MX,7\n", "MX,8\n"]) {
    const written = await fetch(`${workshop.address}/api/files/other.sbp?replace=1`, {
      method: "PUT",
      body: text,
    });
    expect(written.ok).toBe(true);
  }
  await use("Versions…", /other\.sbp/);
  const looks = page.getByRole("button", { name: /^Look at version/ });
  await looks.first().click();
  await page.locator(".file-text pre", { hasText: "MX,7" }).waitFor();
  await shot("version");
  await page
    .getByRole("button", { name: /^Bring version/ })
    .first()
    .click();
  await expect.poll(() => read("other.sbp")).toBe("MX,7\n");
});

it("a file that opens late does not close the list that was opened again meanwhile", async () => {
  const late = await openWorkshop({ lagMs: 1500, parts: ["01-first-cut/first-cut.sbp"] });
  const slow = await late.page();
  const list = slow.getByRole("dialog", { name: "Part folder" });
  await slow.locator(".state", { hasText: "Disarmed" }).waitFor();
  await slow.keyboard.press("Control+o");
  await list.getByRole("option", { name: /first-cut/ }).click();
  await slow.keyboard.press("Escape");
  await list.waitFor({ state: "detached" });
  await slow.keyboard.press("Control+o");
  await list.waitFor();
  await until(
    async () => (await stateOf(late)).opened !== null,
    "it is opened, and the page knows",
  );
  await slow.waitForTimeout(300);
  expect(await list.count()).toBe(1);
  await late.close();
});
