/** Files of this computer on their way into the part folder: chosen, dropped, asked about, held, refused. */

import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  truncateSync,
  writeFileSync,
} from "node:fs";
import { basename, join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, beforeEach, expect, it } from "vitest";
import { mostBytes } from "../../src/link/send";
import type { SettingArea } from "../../src/wire/messages";
import { arm, openWorkshop, script, stateOf, until, violations, type Workshop } from "./workshop";

let workshop: Workshop;
let page: Page;
/** Names of the files that the page has begun to send. */
let sent: string[] = [];

const place = (name: string) => join(workshop.parts, name);
const bytes = (name: string) => readFileSync(place(name));
/** Every byte, in an order that tells where one is missing. */
const sample = Buffer.from(Array.from({ length: 6000 }, (_, n) => (n * 2_654_435_761) >> 13));

interface Given {
  readonly name: string;
  readonly mimeType: string;
  readonly buffer: Buffer;
}

const given = (name: string, content: string | Buffer): Given => ({
  name,
  mimeType: "",
  buffer: Buffer.from(content),
});

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 1 });
  page = await workshop.page();
  page.on("request", (request) => {
    if (request.method() === "PUT") sent.push(decodeURIComponent(new URL(request.url()).pathname));
  });
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  sent = [];
  await page.keyboard.press("Control+o");
  await page.getByRole("dialog", { name: "Part folder" }).waitFor();
});
afterEach(async () => {
  await page.unrouteAll();
  for (let n = 0; n < 3 && (await page.getByRole("dialog").count()) > 0; n += 1)
    await page.keyboard.press("Escape");
});

/** Presses Upload… and chooses files in what the browser opens. */
async function upload(files: readonly Given[] | string): Promise<void> {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Upload…" }).click();
  await (await chooser).setFiles(files as string);
}

const says = (name: string, words: string) =>
  page
    .getByRole("list", { name: "Uploads" })
    .getByRole("listitem")
    .filter({ hasText: name })
    .filter({ hasText: words })
    .first();
const settingOf = async (key: string): Promise<string | undefined> => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  return areas.flatMap(({ settings }) => settings).find((setting) => setting.key === key)?.value;
};
const press = (name: string) => page.getByRole("button", { name, exact: true }).click();

it("pro_send_http: files chosen in the browser lie in the part folder byte for byte, and one is opened", async () => {
  await upload([given("SAMPLE 1.RSM", sample), given("moves.sbp", "MX,1\nEND\n")]);
  await says("SAMPLE 1.RSM", "is in the part folder, 6 kB").waitFor();
  await says("moves.sbp", "is in the part folder").waitFor();
  expect(bytes("SAMPLE 1.RSM").equals(sample)).toBe(true);
  expect(bytes("moves.sbp").toString()).toBe("MX,1\nEND\n");
  expect(await violations(page)).toEqual([]);
  // Nothing is opened by itself, as with `kerf send`.
  expect((await stateOf(workshop)).opened).toBeNull();
  await press("Open moves.sbp");
  await until(async () => (await stateOf(workshop)).opened?.name === "moves.sbp", "it is opened");
  await page.getByRole("dialog").waitFor({ state: "detached" });
});

it("a file that is brought alone is opened as soon as it is there", async () => {
  await upload([given("alone.sbp", "MX,1\nEND\n")]);
  await until(async () => (await stateOf(workshop)).opened?.name === "alone.sbp", "it is opened");
  await page.getByRole("dialog").waitFor({ state: "detached" });
});

it("pro_send_http: a file that is there is replaced only by whoever says so", async () => {
  writeFileSync(place("door.sbp"), "MX,1\nEND\n");
  await upload([given("door.sbp", "MX,2\nEND\n")]);
  await says("door.sbp", "is there already: a part program of 2 lines").waitFor();
  expect(await violations(page)).toEqual([]);
  await press("Leave it");
  await says("door.sbp", "the file that is there is as it was").waitFor();
  expect(bytes("door.sbp").toString()).toBe("MX,1\nEND\n");
  await upload([given("door.sbp", "MX,2\nEND\n")]);
  await press("Replace");
  await says("door.sbp", "is in the part folder").waitFor();
  expect(bytes("door.sbp").toString()).toBe("MX,2\nEND\n");
});

it("pro_send_http: whoever closes the list meanwhile is told that it did not come", async () => {
  writeFileSync(place("gate.sbp"), "MX,1\nEND\n");
  await upload([given("gate.sbp", "MX,2\nEND\n")]);
  await says("gate.sbp", "is there already").waitFor();
  await page.keyboard.press("Escape");
  await page.locator(".notice", { hasText: "gate.sbp is not uploaded" }).waitFor();
  expect(bytes("gate.sbp").toString()).toBe("MX,1\nEND\n");
});

it("pro_send_http: while the machine moves nothing is taken; it is sent when it stands, or stopped", async () => {
  await page.keyboard.press("Escape");
  writeFileSync(place("long.sbp"), "MS,1,1\nMX,0\nMX,4\nEND\n");
  await script(workshop, "open", { name: "long.sbp" });
  await arm(page);
  const running = async () => (await stateOf(workshop)).machine.state === "running";
  for (const [name, isStopped] of [
    ["held.rsm", false],
    ["stopped.rsm", true],
  ] as const) {
    await page.getByRole("button", { name: "Start" }).click();
    await until(running, "it moves");
    await page.keyboard.press("Control+o");
    await upload([given(name, sample)]);
    await says(name, "held: the machine moves").waitFor();
    expect(await running(), "it moves still").toBe(true);
    expect(existsSync(place(name))).toBe(false);
    expect(sent).toEqual([]);
    if (isStopped) await press(`Stop sending ${name}`);
    await until(async () => !(await running()), "it stands");
    await says(name, isStopped ? "stopped" : "is in the part folder").waitFor();
    expect(existsSync(place(name))).toBe(!isStopped);
    await page.keyboard.press("Escape");
    sent = [];
  }
  expect(bytes("held.rsm").equals(sample)).toBe(true);
});

it("pro_send_http: a file that is too large is refused with the limit before a byte is sent", async () => {
  const large = join(workshop.parts, ".large.rsm");
  writeFileSync(large, "");
  truncateSync(large, mostBytes + 1);
  await upload(large);
  await says(".large.rsm", "it has 129 MB, and 128 MB is the most").waitFor();
  expect(sent).toEqual([]);
});

it("pro_send_http: a name that leads elsewhere is refused in the server's words", async () => {
  await upload([given(".hidden.sbp", "MX,1\n")]);
  await says(".hidden.sbp", "is no name of a file in the part folder").waitFor();
});

it("pro_send_http: a file that is damaged on its way is refused, and so is one that does not arrive", async () => {
  await page.route("**/api/files/*", (route) => {
    const damaged = Buffer.from(sample);
    damaged[2500] = (damaged[2500] ?? 0) ^ 1;
    return route.continue({ postData: damaged });
  });
  await upload([given("damaged.rsm", sample)]);
  await says("damaged.rsm", "the file is damaged: send it again").waitFor();
  await page.unrouteAll();
  await page.route("**/api/files/*", (route) => route.abort());
  await upload([given("lost.rsm", sample)]);
  await says("lost.rsm", "the server does not answer").waitFor();
  expect(readdirSync(workshop.parts).filter((name) => /damaged|lost/.test(name))).toEqual([]);
});

/**
 * Drags files of the disk onto the page and lets go, as the browser hears it from the desk; and again where the page was
 * too busy to hear it, as a person does.
 */
async function drop(files: readonly string[], x: number, y: number): Promise<void> {
  const browser = await page.context().newCDPSession(page);
  const data = { items: [], files: [...files], dragOperationsMask: 1 };
  const drag = (type: "dragEnter" | "dragOver" | "drop") =>
    browser.send("Input.dispatchDragEvent", { type, x, y, data });
  const told = page.getByText("Let go: the files are sent into the part folder.");
  const listed = says(basename(files[0] ?? ""), "");
  await until(async () => {
    await drag("dragEnter");
    await drag("dragOver");
    if ((await told.count()) === 0) return false;
    await drag("drop");
    return listed.waitFor({ timeout: 5000 }).then(
      () => true,
      () => false,
    );
  }, "the page says what letting go means, and lists what was dropped");
  await browser.detach();
}

it("pro_send_http: files are dropped onto the list, or anywhere on the page", async () => {
  const [dropped, other] = [place("x/in.rsm"), place("x/b.nc")];
  mkdirSync(place("x"));
  writeFileSync(dropped, sample);
  writeFileSync(other, "G1 X1\n");
  await drop([dropped, other], 500, 300);
  await says("in.rsm", "is in the part folder").waitFor();
  await says("b.nc", "is in the part folder").waitFor();
  expect(bytes("in.rsm").equals(sample)).toBe(true);
  await page.keyboard.press("Escape");
  await page.getByRole("link", { name: "Help" }).click();
  writeFileSync(dropped, "other");
  await drop([dropped], 600, 400);
  await says("in.rsm", "is there already").waitFor();
  await press("Replace");
  // A file that is brought alone is opened, which closes the list.
  await until(async () => bytes("in.rsm").toString() === "other", "it is replaced");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  expect(bytes("in.rsm").toString()).toBe("other");
  expect(page.url()).toBe(`${workshop.address}/help`);
});

it("a picture that is brought is converted, and settings that are brought are loaded after a question", async () => {
  const [picture, settings] = [place("x/plate.png"), place("x/mine.txt")];
  copyFileSync(join(import.meta.dirname, "../../../docs/figures/screen-help-390.png"), picture);
  writeFileSync(settings, "# Kerf: settings of the machine mill\nview.grid_mm = 12\n");
  await page.getByRole("link", { name: "Operate" }).click();
  await drop([picture], 500, 300);
  const sheet = page.getByRole("dialog", { name: /^FC / });
  await sheet.waitFor();
  expect(await sheet.getByLabel("File name").inputValue()).toBe("plate.png");
  await page.keyboard.press("Escape");
  await drop([settings], 500, 300);
  const question = page.getByRole("dialog", { name: "Load settings?" });
  await question.getByRole("button", { name: "Change 1 setting" }).click();
  await until(async () => (await settingOf("view.grid_mm")) === "12", "the setting is loaded");
});

it("nothing else went wrong on the page", () => {
  const refusals = /Failed to load resource/;
  expect(workshop.mistakes.filter((told) => !refusals.test(told))).toEqual([]);
});
