/** Prints the state of every page and of the machine when a test failed, beside its error. */

import type { Page } from "playwright-core";
import { afterEach } from "vitest";
import { openWorkshops, stateOf } from "./workshop";

const text = (page: Page, of: string) => page.locator(of).allTextContents();

async function shown(page: Page): Promise<string[]> {
  const [state, notices] = [await text(page, ".state"), await text(page, ".notice-words")];
  const dialogs = await page
    .getByRole("dialog")
    .evaluateAll((all) => all.map((one) => one.textContent?.slice(0, 200) ?? ""));
  return [`page ${page.url()}: ${state.join()}`, ...notices, ...dialogs.map((d) => `dialog: ${d}`)];
}

afterEach(async ({ task }) => {
  if (task.result?.state !== "fail") return;
  for (const workshop of openWorkshops) {
    for (const page of workshop.pages) console.log((await shown(page).catch(String)).toString());
    const now = await stateOf(workshop).catch(() => undefined);
    if (!now) continue;
    const { machine, job, asked, messages } = now;
    console.log(JSON.stringify({ machine, job, asked, messages: messages.slice(-5) }));
  }
});
