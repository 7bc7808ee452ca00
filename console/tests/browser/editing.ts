/** The editor of part files, as a person works in it. */

import type { Page } from "playwright-core";

/** Goes to the editor and opens a file in it. */
export async function edit(page: Page, name: string): Promise<void> {
  await page.getByRole("link", { name: "Edit" }).click();
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("option", { name: new RegExp(name.replace(".", "\\.")) }).click();
  await page.locator(".edit-head h1", { hasText: name }).waitFor();
}

/** Types a line at the end of the text. */
export async function type(page: Page, line: string): Promise<void> {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type(`${line}\n`);
}

/** The lines that are in sight. */
export const text = async (page: Page): Promise<string> =>
  (await page.locator(".cm-line").allTextContents()).join("\n");
