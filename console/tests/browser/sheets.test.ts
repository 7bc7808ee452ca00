/** Every fill-in sheet of the table of commands: opened, filled with what has to be given, and run. */

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { CommandEntry, Parameter } from "../../src/wire/messages";
import { arm, fullFace, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;
let table: readonly CommandEntry[];

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 200 });
  writeFileSync(join(workshop.parts, "a.sbp"), "PAUSE 0.1\nEND\n");
  page = await workshop.page();
  await fullFace(page);
  await arm(page);
  table = (await (await fetch(`${workshop.address}/api/commands`)).json()) as CommandEntry[];
});
afterAll(() => workshop?.close());

/** Something that a parameter accepts. */
function fitting({ kind, least, most }: Parameter): string {
  if (kind.is === "choice") return kind.words[0] ?? "";
  if (kind.is === "file") return "a.sbp";
  if (kind.is === "text") return "a";
  if (kind.is === "axis") return "X";
  return String(Math.min(Math.max(1, least ?? 1), most ?? 1));
}

/** Answers and gives up whatever the command began, until the machine stands. */
async function ends(): Promise<void> {
  await until(async () => {
    const { machine, asked } = await stateOf(workshop);
    if (machine.state === "idle") return true;
    if (machine.state === "alarm") await script(workshop, "acknowledge");
    else if (asked) await script(workshop, "stop");
    return false;
  }, "the machine stands");
}

/** The sheet of a command, opened as the menus do. */
async function opened({ letters, group }: CommandEntry): Promise<void> {
  await page.getByRole("link", { name: "Operate" }).click();
  const arms = page.getByRole("button", { name: "Arm", exact: true });
  if ((await arms.count()) > 0) await arms.click();
  const title = group === "cut" ? "Cuts" : `${group[0]?.toUpperCase()}${group.slice(1)}`;
  await page
    .getByRole("navigation", { name: "Commands" })
    .getByText(title, { exact: true })
    .click();
  await page.getByRole("menuitem", { name: new RegExp(`^${letters} `) }).click();
  await page.getByRole("dialog", { name: new RegExp(`^${letters} `) }).waitFor();
}

/** Fills what has to be given, presses OK, and gives the line that ran. */
async function run(entry: CommandEntry): Promise<string> {
  const sheet = page.getByRole("dialog", { name: new RegExp(`^${entry.letters} `) });
  for (const parameter of entry.parameters.filter(({ required }) => required)) {
    if (parameter.kind.is === "choice") {
      await sheet.getByRole("radio").first().click();
      continue;
    }
    const field = sheet.getByRole("textbox", { name: new RegExp(`^${parameter.name}`) }).first();
    if ((await field.inputValue()) === "") await field.fill(fitting(parameter));
  }
  const line = (await sheet.locator(".sheet-line").textContent()) ?? "";
  await sheet.getByRole("button", { name: /^(OK|Cut)$/ }).click();
  const refused = page.locator(".notice").filter({ hasText: /./ });
  await Promise.race([sheet.waitFor({ state: "detached" }), refused.first().waitFor()]);
  if (await sheet.isVisible()) {
    const words = (await refused.last().textContent()) ?? "";
    for (const one of await refused.getByRole("button").all()) await one.click();
    throw new Error(`refused: ${words}`);
  }
  return line;
}

it("every sheet opens, shows its fields, and runs", async () => {
  const sheets = table.filter(({ parameters }) => parameters.length > 0);
  expect(sheets.length).toBeGreaterThan(60);
  const failed: string[] = [];
  for (const entry of sheets) {
    try {
      await opened(entry);
      const line = await run(entry);
      await until(async () => (await stateOf(workshop)).job?.command === line, `${line} runs`);
      await ends();
    } catch (error) {
      failed.push(`${entry.letters}: ${String(error).split("\n")[0]}`);
      await ends().catch(() => undefined);
      await page.keyboard.press("Escape");
    }
  }
  expect(failed).toEqual([]);
}, 600_000);
