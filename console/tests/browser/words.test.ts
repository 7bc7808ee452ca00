import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { starred } from "../../src/settings/names";
import type { CommandEntry, OperationEntry, SettingArea } from "../../src/wire/messages";
import { untold as untoldOfCommand } from "../../src/words/commands";
import { settingNames } from "../../src/words/english/machineSettings";
import { german } from "../../src/words/german/german";
import { machineSettings, topics } from "../../src/words/german/machineSettings";
import { deviceWords, settingWords } from "../../src/words/german/settingWords";
import { untold as untoldOfOperation } from "../../src/words/operations";
import { overlaps } from "./overlaps";
import { sizes } from "./sizes";
import { openWorkshop, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({ parts: ["01-first-cut/first-cut.sbp"], open: "first-cut.sbp" });
});
afterAll(() => workshop?.close());

/** Texts that have another form in German; a text with a value in it counts by what stands around the value. */
const others = Object.entries(german)
  .filter(([english, words]) => english !== words && !Object.values(german).includes(english))
  .map(([english]) => english);

/** The English texts that a page shows, or tells whoever does not see it. */
const englishOn = (page: Page): Promise<string[]> =>
  page.evaluate((known) => {
    const exact = new Set(known.filter((text) => !/\{\d\}/.test(text)));
    const patterns = known
      .filter((text) => /\{\d\}/.test(text) && text.replace(/\{\d\}|[^a-z]/gi, "").length > 5)
      .map((text) =>
        text
          .split(/\{\d\}/)
          .map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"))
          .join(".*"),
      );
    const pattern = new RegExp(`^(?:${patterns.join("|")})$`);
    const said: string[] = [];
    // The book and the changelog are written in English.
    const others = "script, style, kbd, .book, .help-news";
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode())
      if (!node.parentElement?.closest(others)) said.push(node.textContent ?? "");
    for (const element of document.querySelectorAll(`:not(:is(${others}) *, :is(${others}))`))
      for (const name of ["aria-label", "title", "placeholder", "alt"])
        said.push(element.getAttribute(name) ?? "");
    const texts = said.map((text) => text.replace(/\s+/g, " ").trim()).filter((text) => text);
    return [...new Set(texts.filter((text) => exact.has(text) || pattern.test(text)))];
  }, others);

it("every setting of the machine has a German name and description", async () => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  expect(areas.length).toBeGreaterThan(30);
  const titles = areas.map(({ title }) => title).filter((title) => topics[title] === undefined);
  const keys = areas.flatMap(({ settings }) => settings).map(({ key }) => key);
  const without = keys.filter((key) => !machineSettings[key] && !machineSettings[starred(key)]);
  expect({ titles, without }).toEqual({ titles: [], without: [] });
  const english = Object.keys(settingNames).filter((key) => !machineSettings[key]);
  expect(english).toEqual([]);
});

it("every word that a setting may be is told in German", async () => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  const kinds = areas.flatMap(({ settings }) => settings.map(({ kind }) => kind));
  const words = kinds.flatMap((kind) => (kind.is === "choice" ? kind.words : []));
  expect(words.length).toBeGreaterThan(50);
  // Letters of axes and units are the same in every language.
  const told = (word: string) =>
    word.length < 3 || settingWords[word] || deviceWords.includes(word);
  expect([...new Set(words.filter((word) => !told(word)))]).toEqual([]);
});

it("every command and every operation of drawings is told in German", async () => {
  const table = await (await fetch(`${workshop.address}/api/commands`)).json();
  expect(table.length).toBeGreaterThan(100);
  expect((table as CommandEntry[]).flatMap(untoldOfCommand)).toEqual([]);
  const all = await (await fetch(`${workshop.address}/api/drawing/operations`)).json();
  expect(all.length).toBeGreaterThan(40);
  expect((all as OperationEntry[]).flatMap(untoldOfOperation)).toEqual([]);
});

const screens = ["Bedienen", "Text", "Zeichnen", "Setup", "Hilfe"];

const sheets = [
  "Datei öffnen",
  "Tastenfeld",
  "Notizblock",
  "Rechner",
  "Werte und Variablen",
  "Werkstück rücken",
  "Werkzeug zu einem Ort",
  "Aufgezeichnete Befehle",
  "Virtuelle Werkzeuge",
  "Eingänge der Maschine",
  "Anschlüsse der Karte",
  "Zeitverlauf",
  "Maschine einrichten",
  "Verlauf der Läufe",
  "Aufträge zu erledigen",
  "Beispielantworten",
  "Makros",
  "Tasten der Aktionen",
];

async function speakGerman(page: Page): Promise<void> {
  await page.getByRole("link", { name: "Settings" }).click();
  await page.getByRole("radio", { name: "Deutsch" }).click();
  await page.getByRole("link", { name: "Bedienen" }).waitFor();
}

it.each(sizes)(
  "every screen speaks German when it is chosen, at $width by $height",
  async (size) => {
    const page = await workshop.page(size);
    await speakGerman(page);
    expect(await page.locator("html").getAttribute("lang")).toBe("de");
    const found: string[] = [];
    for (const name of screens) {
      await page.getByRole("link", { name, exact: true }).click();
      await page.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
      const faults = [...(await overlaps(page)), ...(await violations(page))];
      found.push(...[...faults, ...(await englishOn(page))].map((fault) => `${name}: ${fault}`));
      if (process.env.PICTURES)
        await page.screenshot({ path: `${process.env.PICTURES}/${name}-${size.width}.png` });
    }
    expect(found).toEqual([]);
    await page.close();
  },
);

it("every sheet speaks German, and the page after it was loaded again", async () => {
  const page = await workshop.page({ width: 1440, height: 900 });
  await speakGerman(page);
  await page.reload();
  await page.getByRole("link", { name: "Bedienen", exact: true }).click();
  const found: string[] = [];
  for (const name of sheets) {
    await page.keyboard.press("Control+k");
    await page.getByRole("dialog", { name: "Alle Aktionen" }).waitFor();
    await page.keyboard.type(name);
    await page.getByRole("option", { name }).first().waitFor();
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: "Alle Aktionen" }).waitFor({ state: "detached" });
    await page.getByRole("dialog").first().waitFor();
    const faults = [...(await overlaps(page)), ...(await violations(page))];
    found.push(...[...faults, ...(await englishOn(page))].map((fault) => `${name}: ${fault}`));
    if (process.env.PICTURES)
      await page.screenshot({ path: `${process.env.PICTURES}/sheet-${name.split(" ")[0]}.png` });
    await page.keyboard.press("Escape");
    await page.getByRole("dialog").first().waitFor({ state: "detached" });
  }
  expect(found).toEqual([]);
  await page.close();
});

/** A page in German with the command line, on a machine that is armed. */
async function germanDesk(): Promise<Page> {
  const page = await workshop.page({ width: 1440, height: 900 });
  await page.evaluate(() => localStorage.setItem("kerf.language", "de"));
  await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "never"));
  await page.reload();
  await page.getByRole("button", { name: "Freigeben", exact: true }).click();
  await page.locator(".state", { hasText: "Bereit" }).waitFor();
  return page;
}

async function types(page: Page, line: string): Promise<void> {
  await page.getByLabel("Befehlszeile").fill(line);
  await page.keyboard.press("Enter");
}

/** Types a line and waits until it has ended so. */
async function runs(page: Page, line: string, ended: string): Promise<void> {
  await types(page, line);
  await until(async () => (await stateOf(workshop)).job?.command === line, `${line} begins`);
  await until(async () => (await stateOf(workshop)).job?.ended === ended, `${line}: ${ended}`);
}

it("questions, messages and alarms are German, and answers arrive all the same", async () => {
  const file = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  file("limit.sbp", "MX,12\nEND\n");
  file("unknown.sbp", "MX,&nothing\nEND\n");
  file(
    "clamped.sbp",
    'MSGBOX(Is it clamped?, YesNo)\nIF &msganswer = "NO" THEN GOTO LOOSE\nMX,1\nEND\nLOOSE:\nMX,2\n',
  );
  const page = await germanDesk();
  const dialog = page.getByRole("dialog");
  // What the program asks stays as it was written; the words on its buttons are Kerf's.
  await types(page, "FP,clamped.sbp");
  await dialog.getByText("Is it clamped?").waitFor();
  await dialog.getByRole("button", { name: "Nein", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is done");
  expect((await stateOf(workshop)).motion.at.working[0]).toBeCloseTo(50.8);
  await runs(page, "FP,unknown.sbp", "failed");
  await page.locator(".word-error", { hasText: "Die Variable &NOTHING hat keinen Wert" }).waitFor();
  await runs(page, "VL,0,10", "ok");
  await runs(page, "SF,1", "ok");
  await types(page, "FP,limit.sbp");
  const limits = page.getByRole("dialog", { name: "Grenzen" });
  await limits.getByText(/X käme nach 12, die Tischgrenze ist 10/).waitFor();
  await limits.getByRole("button", { name: "Ende", exact: true }).click();
  await page.locator(".state-why", { hasText: "die Tischgrenze ist 10" }).waitFor();
  await page.close();
});
