/** `kerf serve --drawing-only`: drawings and files, and nothing of the machine. */

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { act, openWorkshop, script, stateOf, type Workshop } from "./workshop";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({ drawingOnly: true });
});
afterAll(() => workshop?.close());

it("leads to the drawing whatever address is asked for, without a way to the machine", async () => {
  const page = await workshop.page();
  for (const address of ["/", "/settings", "/draw"]) {
    await page.goto(`${workshop.address}${address}`);
    await page.getByRole("application", { name: "Shapes of the drawing" }).waitFor();
    await page.getByText("Drawings only: the machine is left alone").waitFor();
    const links = await page
      .getByRole("navigation", { name: "Screens" })
      .getByRole("link")
      .allTextContents();
    expect(links).toEqual(["Edit", "Draw", "Help"]);
    expect(await page.getByRole("button", { name: "Arm" }).count()).toBe(0);
  }
  await act(page, "arm the machine");
  await page
    .getByText(/not available in the editing version|only drawings/)
    .first()
    .waitFor();
  expect((await stateOf(workshop)).machine.armed).toBe(false);
  await page.keyboard.press("k");
  await page.keyboard.press("Escape");
});

it("draws and writes a part program", async () => {
  const page = await workshop.page();
  await page.getByRole("button", { name: "New", exact: true }).click();
  await script(workshop, "draw", { op: { op: "do", clauses: "rect 0,0 50,30" } });
  await page.getByRole("button", { name: "Make the part program…" }).click();
  await page.getByRole("button", { name: "Write" }).click();
  await page.getByText("drawing.sbp is written into the part folder.").waitFor();
  expect(existsSync(join(workshop.parts, "drawing.sbp"))).toBe(true);
});

it("pro_send_http: a file is brought into the part folder", async () => {
  const page = await workshop.page();
  await page.getByRole("button", { name: "Open…" }).click();
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Upload…" }).click();
  const buffer = Buffer.from("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n");
  await (await chooser).setFiles([{ name: "plate.dxf", mimeType: "", buffer }]);
  await page.getByText("is in the part folder").waitFor();
  expect(readFileSync(join(workshop.parts, "plate.dxf")).equals(buffer)).toBe(true);
});

it("no act reaches the machine, with a lease or without", async () => {
  const before = await stateOf(workshop);
  const acts: Record<string, object> = {
    takeLease: { force: true },
    arm: { lease: 1 },
    command: { lease: 1, line: "MX,1" },
    run: { lease: 1, hash: "" },
    takeUp: { lease: 1 },
    nudge: { lease: 1, axis: "X", distance: 1 },
    input: { lease: 1, number: 1, on: true },
    set: { lease: 1, key: "axes", value: "4" },
    override: { lease: 1, feedPercent: 50 },
    resume: { lease: 1 },
    answer: { question: 0, answer: "OK" },
    folder: { name: "", mask: "*" },
    record: { line: "MX,1" },
    watch: { names: ["&a"] },
    acknowledge: {},
  };
  for (const [act, body] of Object.entries(acts)) {
    expect(await script(workshop, act, body), act).toBe(409);
  }
  const after = await stateOf(workshop);
  for (const part of [
    "machine",
    "motion",
    "io",
    "folder",
    "recorder",
    "watched",
    "lease",
  ] as const) {
    expect(after[part], part).toEqual(before[part]);
  }
});
