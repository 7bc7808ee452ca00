/** A long part file in the editor: no key waits for all of it, and nothing is told that nobody looked at. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import type { TextDraft } from "../../src/wire/messages";
import { text } from "./editing";
import { openWorkshop, until, type Workshop } from "./workshop";

let folder: string;
let workshop: Workshop;

const lines = Array.from({ length: 120_000 }, (_, n) => `M3,${n % 20},${n % 7},-0.1`);
const long = `${lines.join("\r\n")}\r\n`;

beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), "kerf-long-"));
  writeFileSync(join(folder, "long.sbp"), long);
  workshop = await openWorkshop({ folder });
});
afterEach(async () => {
  expect(workshop.mistakes).toEqual([]);
  await workshop?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Shows the file in the editor. */
async function edit(page: Page): Promise<void> {
  const last = JSON.stringify({ name: "long.sbp", opened: "" });
  await page.evaluate((kept) => sessionStorage.setItem("kerf.edited", kept), last);
  await page.getByRole("link", { name: "Edit" }).click();
  await page.locator(".edit-head h1", { hasText: "long.sbp" }).waitFor();
  await page.locator(".cm-line", { hasText: "M3,0,0" }).first().waitFor();
}

/** Types at the beginning and at the end. */
async function typeAtBothEnds(page: Page): Promise<void> {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("' mine\n");
  await page.keyboard.press("Control+End");
  await page.keyboard.type("M3,1,(2\n");
}

const drafts = async (): Promise<TextDraft[]> => {
  const asked = await fetch(`${workshop.address}/api/texts`, { headers: workshop.shows });
  return (await asked.json()) as TextDraft[];
};

const edits = [
  { line: 1, count: 1, lines: ["' mine", "M3,0,0,-0.1"] },
  { line: 120_001, count: 1, lines: ["M3,1,(2", ""] },
];

/** Waits until the server has what was typed. */
const kept = () =>
  until(
    async () => JSON.stringify((await drafts())[0]?.edits) === JSON.stringify(edits),
    "what was typed is kept",
  );

const shows = (page: Page, line: string) =>
  until(async () => (await text(page)).includes(line), `the editor shows ${line}`);

it("no key sends all of it, and a killed server loses none", async () => {
  const page = await workshop.page();
  await edit(page);
  let most = 0;
  page.on("request", (request) => {
    most = Math.max(most, request.postData()?.length ?? 0);
  });
  await typeAtBothEnds(page);
  await kept();
  await page.getByText("Each line was checked by itself").waitFor();
  expect(most).toBeGreaterThan(100_000);
  expect(most).toBeLessThan(long.length / 4);
  await workshop.kill();
  workshop = await openWorkshop({ folder });
  const other = await workshop.page();
  await other.getByRole("link", { name: "Edit" }).click();
  await shows(other, "' mine");
  await other.locator(".edit-changed").waitFor();
  await other.getByRole("button", { name: "Save", exact: true }).click();
  await other.locator(".edit-changed").waitFor({ state: "detached" });
  const [first, ...rest] = readFileSync(join(folder, "long.sbp"), "utf8").split("\r\n");
  expect([first, ...rest.slice(-3)]).toEqual(["' mine", lines.at(-1), "M3,1,(2", ""]);
  expect(rest.length).toBe(lines.length + 2);
  expect(await drafts()).toEqual([]);
});

it("a file that was changed on the disk meanwhile loses neither text", async () => {
  const page = await workshop.page();
  await edit(page);
  await typeAtBothEnds(page);
  await kept();
  writeFileSync(join(folder, "long.sbp"), "' theirs\n");
  await page.reload();
  await page.getByText("was changed on the disk since this text was typed").waitFor();
  await shows(page, "' mine");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  const asks = page.getByRole("dialog");
  await asks.getByText("long.sbp").first().waitFor();
  await asks.getByRole("button", { name: "Cancel" }).click();
  expect(readFileSync(join(folder, "long.sbp"), "utf8")).toBe("' theirs\n");
  workshop.mistakes.length = 0;
});

it("a mistake is found in a long text, and what was not looked at is told", async () => {
  const page = await workshop.page();
  const said = page.getByLabel("Findings");
  let answers = () => {};
  const asked = new Promise<void>((done) => {
    answers = done;
  });
  await page.route("**/api/language/check", async (route) => {
    await asked;
    await route.continue();
  });
  await edit(page);
  await said.getByText("Not checked yet: 100 % of the text.").waitFor();
  answers();
  await said.getByText("Each line was checked by itself").waitFor();
  expect(await said.getByRole("listitem").count()).toBe(0);
  await typeAtBothEnds(page);
  const place = said.getByRole("button", { name: /120002/ });
  await place.waitFor();
  await said.getByText("Not checked: jumps, variables and units.").waitFor();
  expect(await said.getByText("No mistakes found").count()).toBe(0);
  await page.locator(".cm-content").press("Control+Home");
  await place.click();
  await shows(page, "M3,1,(2");
  await page.locator(".cm-lintRange-error").first().waitFor();
});
