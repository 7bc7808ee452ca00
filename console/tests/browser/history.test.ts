/** Runs are on record, jobs to be done are on a list, and another program and the browser are told. */

import { writeFileSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import { afterEach, beforeEach, expect, it } from "vitest";
import {
  act,
  arm,
  openWorkshop,
  script,
  stateOf,
  until,
  violations,
  type Workshop,
} from "./workshop";

let workshop: Workshop;
let hook: Server;
const told: { event: string; file: string; text: string }[] = [];

beforeEach(async () => {
  told.length = 0;
  hook = createServer((request, answer) => {
    let body = "";
    request.on("data", (bytes) => {
      body += bytes;
    });
    request.on("end", () => {
      told.push(JSON.parse(body));
      answer.end("taken");
    });
  });
  await new Promise<void>((listens) => hook.listen(0, "127.0.0.1", listens));
});
afterEach(async () => {
  hook.close();
  await workshop?.close();
});

const ready = (name: string) =>
  until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, `${name} is previewed`);

const over = () => until(async () => (await stateOf(workshop)).job?.ended !== null, "it is over");

it("a run is on the list of jobs, in the history, in the counter, and told to another program", async () => {
  const webhook = `http://127.0.0.1:${(hook.address() as AddressInfo).port}/kerf`;
  workshop = await openWorkshop({ rate: 50, webhook });
  const write = (name: string, text: string) => writeFileSync(join(workshop.parts, name), text);
  write("part.sbp", 'SA\nMSGBOX("Is the clamp off?",OKOnly,"Clamp")\nM2,1,0\nM2,0,0\n');
  write("fails.sbp", "SA\nM2,1,1\nPAUSE .1\nM2,&far,1\n");
  await script(workshop, "open", { name: "part.sbp" });
  await ready("part.sbp");
  const page = await workshop.page();
  await page.locator(".job-name", { hasText: "part.sbp" }).waitFor();
  await page.keyboard.press("Control+o");
  await page.getByRole("button", { name: "Jobs to do…" }).click();
  await page.getByRole("button", { name: "Add the open file" }).click();
  await page.getByRole("button", { name: "One more of part.sbp" }).click();
  const todo = page.getByRole("list", { name: "Jobs to do" });
  await todo.filter({ hasText: "0 of 2 made" }).waitFor();
  await page.keyboard.press("Escape");
  await arm(page);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await page.getByRole("button", { name: "OK" }).click();
  await over();
  await script(workshop, "open", { name: "fails.sbp" });
  await ready("fails.sbp");
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await until(async () => (await stateOf(workshop)).job?.ended === "failed", "it failed");
  await act(page, "jobs to do");
  await todo.filter({ hasText: "1 of 2 made" }).waitFor();
  expect(await violations(page)).toEqual([]);
  await page.screenshot({ path: process.env.KERF_SHOT_TODO ?? "/dev/null", type: "png" });
  await page.getByRole("button", { name: "Close" }).first().click();
  await page.keyboard.press("Control+o");
  await page.getByRole("button", { name: "History…" }).click();
  const rows = page.getByRole("table", { name: "Runs" }).locator("tbody tr");
  await expect.poll(() => rows.count()).toBe(2);
  expect(await rows.first().textContent()).toMatch(/fails\.sbpfailed behind line 2/);
  expect(await rows.last().textContent()).toMatch(/part\.sbpfinished.*this machine/);
  await page.getByLabel("Parts made").filter({ hasText: "part.sbp 1 today, 1 in all" }).waitFor();
  expect(await violations(page)).toEqual([]);
  await expect.poll(() => told.length).toBe(3);
  expect(told.map(({ event, file }) => `${event} ${file}`)).toEqual([
    "needs you part.sbp",
    "done part.sbp",
    "failed fails.sbp",
  ]);
  expect(workshop.mistakes).toEqual([]);
});

it("the browser notifies whoever looks at something else", async () => {
  workshop = await openWorkshop({ rate: 50 });
  writeFileSync(join(workshop.parts, "part.sbp"), "SA\nM2,1,0\nM2,0,0\n");
  await script(workshop, "open", { name: "part.sbp" });
  await ready("part.sbp");
  const page = await workshop.page();
  await page.evaluate(() => {
    const shown: string[] = [];
    class Shown {
      static permission = "default";
      static async requestPermission() {
        Shown.permission = "granted";
        return "granted";
      }
      constructor(_: string, { body }: { body: string }) {
        shown.push(body);
      }
    }
    Object.assign(window, { Notification: Shown, shown });
    document.hasFocus = () => false;
  });
  await page.keyboard.press("Control+o");
  await page.getByRole("button", { name: "History…" }).click();
  await page.getByRole("radio", { name: "Notify", exact: true }).click();
  await expect.poll(() => page.evaluate(() => localStorage.getItem("kerf.notify"))).toBe("yes");
  await page.keyboard.press("Escape");
  await arm(page);
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await over();
  await expect
    .poll(() => page.evaluate(() => (window as unknown as { shown: string[] }).shown))
    .toEqual(["part.sbp is done"]);
});
