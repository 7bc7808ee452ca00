/** A real server on the simulated machine and a real browser, for tests. */

import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import type { Browser, Page } from "playwright-core";
import type { Snapshot } from "../../src/wire/messages";
import { browserHere, closeOthers, freshPage } from "./browsers";

const root = resolve(import.meta.dirname, "../../..");
/** The command that is tested. */
export const kerf = process.env.KERF ?? join(root, "target/debug/kerf");

export interface Workshop {
  readonly address: string;
  /** Headers that show that whoever asks sits at the machine, where others may connect. */
  readonly shows: Readonly<Record<string, string>>;
  readonly parts: string;
  readonly browser: Browser;
  /** A page of this size, for fingers where `hasTouch`; what went wrong on it is kept in `mistakes`. */
  page(size?: { width: number; height: number }, hasTouch?: boolean): Promise<Page>;
  /** Every page that was opened here. */
  readonly pages: readonly Page[];
  /** Its pages may hear nothing for a while: what is tested is their link. */
  readonly isDeaf: boolean;
  /** Errors of every page so far. */
  readonly mistakes: string[];
  /** Ends the server as a power cut does, and keeps its folder. */
  kill(): Promise<void>;
  close(): Promise<void>;
}

/** Those that are open in this file of tests. */
export const openWorkshops = new Set<Workshop>();

/** Fetches the server's own state, past every page. */
export async function stateOf(workshop: Workshop): Promise<Snapshot> {
  const { address, shows: headers } = workshop;
  return (await fetch(`${address}/api/state`, { headers })).json() as Promise<Snapshot>;
}

/** Asks the server past every page, as a script does; the state of its answer. */
export async function script(workshop: Workshop, act: string, body: object = {}): Promise<number> {
  const headers = { ...workshop.shows, "content-type": "application/json" };
  const init = { method: "POST", headers, body: JSON.stringify(body) };
  return (await fetch(`${workshop.address}/api/do/${act}`, init)).status;
}

/** Arms the machine, so that it may move. */
export async function arm(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Arm", exact: true }).click();
  await page.locator(".state", { hasText: "Ready" }).waitFor();
}

/** Reads an axis on the location display. */
export async function location(page: Page, axis: string): Promise<number> {
  return Number(await page.locator(`[data-axis="${axis}"]`).textContent());
}

/** The FULL face with its command line. */
export async function fullFace(page: Page): Promise<void> {
  await page.getByRole("radio", { name: "FULL" }).click();
  await page.getByLabel("Command line").waitFor();
}

/** A page with the FULL face on which the sheets stay closed: what is typed is sent as it is. */
export async function commandDesk(workshop: Workshop): Promise<Page> {
  const page = await workshop.page();
  await page.evaluate(() => localStorage.setItem("kerf.face", "full"));
  await page.evaluate(() => localStorage.setItem("kerf.sheets", "never"));
  await page.reload();
  await page.getByLabel("Command line").waitFor();
  return page;
}

/** Types a line at the command line and sends it. */
export async function command(page: Page, line: string): Promise<void> {
  await page.getByLabel("Command line").pressSequentially(line);
  await page.keyboard.press("Enter");
}

/** Types a line, or has a script send it where there is no page, and waits until it is done. */
export async function carryOut(workshop: Workshop, page: Page | null, line: string): Promise<void> {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  if (page) await command(page, line);
  else await script(workshop, "command", { line });
  await until(async () => {
    const { job, machine } = await stateOf(workshop);
    return (job?.run ?? 0) > before && machine.state === "idle";
  }, `${line} is done`);
}

/** Goes with Tab to what has this name, as a person without a mouse does. */
export async function tabTo(page: Page, name: string | RegExp): Promise<void> {
  const wanted = typeof name === "string" ? (text: string) => text === name : name;
  for (let n = 0; n < 250; n += 1) {
    const here = await page.evaluate(() => {
      const at = document.activeElement;
      return (at?.getAttribute("aria-label") ?? at?.textContent ?? "").trim();
    });
    if (wanted instanceof RegExp ? wanted.test(here) : wanted(here)) return;
    await page.keyboard.press("Tab");
  }
  throw new Error(`Tab never comes to ${name}`);
}

/** Goes there and presses Enter. */
export async function enter(page: Page, name: string | RegExp): Promise<void> {
  await tabTo(page, name);
  await page.keyboard.press("Enter");
}

/** Does an action from the list of all: the first that is found by this name. */
export async function act(page: Page, name: string): Promise<void> {
  const entry = page.getByLabel(/^(?:What to do|Was zu tun ist)$/);
  const isThere = () =>
    entry.waitFor({ timeout: 3000 }).then(
      () => true,
      () => false,
    );
  // A page that was just loaded may not hear the key yet.
  for (let tries = 0; tries < 20; tries += 1) {
    if ((await entry.count()) === 0) await page.keyboard.press("Control+k");
    if (await isThere()) break;
  }
  await entry.fill(name);
  await page.getByRole("option", { name }).first().waitFor();
  await page.keyboard.press("Enter");
}

/** Longest time that a test waits for anything before it says that it never comes, milliseconds. */
const patienceMs = 60_000;

/**
 * Waits until something holds, looked at again and again; and until every page has heard what the server
 * has told so far, so that what is pressed next means that.
 */
export async function until(holds: () => Promise<boolean>, words: string): Promise<void> {
  const end = Date.now() + patienceMs;
  while (!(await holds())) {
    if (Date.now() > end) throw new Error(`never: ${words}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  for (const workshop of openWorkshops) await catchUp(workshop);
}

/** Time for which a page is waited for that shows no machine, or may hear nothing. */
const deafMs = 2000;
/** Time that a busy computer may take to draw what a page heard. */
const slowMs = 20_000;

/** Waits until every page has drawn what the server has told so far. */
export async function catchUp(workshop: Workshop): Promise<void> {
  const revision = (await stateOf(workshop).catch(() => undefined))?.revision ?? 0;
  for (const page of workshop.pages.filter((one) => !one.isClosed())) {
    if (workshop.isDeaf) await shows(page, revision, deafMs);
    else if (await shows(page, 1, deafMs)) await shows(page, revision, slowMs);
  }
}

/** Waits until a page shows the machine as it is told with this revision; true where it comes to, in so long. */
function shows(page: Page, revision: number, timeout: number): Promise<boolean> {
  const heard = (least: number) => Number(document.documentElement.dataset.revision) >= least;
  return page.waitForFunction(heard, revision, { timeout }).then(
    () => true,
    () => false,
  );
}

const looks = 100;

/** A short moment between two looks. */
export const moment = (ms = 40) => new Promise<void>((resolve) => setTimeout(resolve, ms));

/** Tells whether nothing moves. */
export const stands = async (workshop: Workshop): Promise<boolean> => {
  const { machine, motion } = await stateOf(workshop);
  return machine.state !== "jogging" && machine.state !== "running" && motion.speedMmS === 0;
};

export interface Hand {
  down(): Promise<void>;
  up(): Promise<void>;
}

/** The keys of a keypad as a hand. */
export const keysOf = (page: Page, keys: readonly string[]): Hand => ({
  async down() {
    for (const key of keys) await page.keyboard.down(key);
  },
  async up() {
    for (const key of [...keys].reverse()) await page.keyboard.up(key);
  },
});

/**
 * Holds what moves the tool until something is so, and does not let go. On a busy computer a link may be
 * slow for a moment, which ends a jog: then it is let go and held again. Gives the machine as it stood
 * before it was held last.
 */
export async function hold(
  workshop: Workshop,
  hand: Hand,
  holds: (now: Snapshot) => boolean | Promise<boolean>,
  words: string,
): Promise<Snapshot> {
  let stood = await stateOf(workshop);
  await until(async () => {
    stood = await stateOf(workshop);
    await hand.down();
    for (let [look, moved] = [0, false]; look < looks; look += 1) {
      const now = await stateOf(workshop);
      if (await holds(now)) return true;
      const moves = now.machine.state === "jogging";
      if (moved && !moves) break;
      moved ||= moves;
      await moment();
    }
    await hand.up();
    await until(() => stands(workshop), "what was begun is over");
    return false;
  }, words);
  return stood;
}

/** Stops and acknowledges until the machine is idle. */
export async function comesToRest(workshop: Workshop): Promise<void> {
  await until(async () => {
    if ((await stateOf(workshop)).machine.state === "idle") return true;
    await script(workshop, "stop");
    await script(workshop, "acknowledge");
    await moment(150);
    return (await stateOf(workshop)).machine.state === "idle";
  }, "the machine is at rest");
}

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

interface Violation {
  id: string;
  nodes: { target: string[]; failureSummary: string }[];
}

/** Violations that axe finds on a page, as lines. */
export async function violations(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axe);
  const found = await page.evaluate(async () => {
    const tool = Reflect.get(window, "axe") as { run(): Promise<{ violations: Violation[] }> };
    return (await tool.run()).violations;
  });
  return found.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(" ")}: ${failureSummary}`),
  );
}

export interface WorkshopOptions {
  /** Part files of the examples that are in the part folder: `01-first-cut/first-cut.sbp`. */
  readonly parts?: readonly string[];
  /** A part folder that was there before, with what an earlier server left in it. */
  readonly folder?: string;
  /** Other devices may come, after pairing; it listens on every address. */
  readonly lan?: boolean;
  /** Drawings only. */
  readonly drawingOnly?: boolean;
  /** Told when somebody is needed and how runs end. */
  readonly webhook?: string;
  /** Opened at the start. */
  readonly open?: string;
  /** The start-up line of the handbooks that begins it, read in the part folder. */
  readonly line?: string;
  /** Address on which it listens; a free port unless told. */
  readonly listen?: string;
  /** A machine that nobody was asked about yet: the page leads through its settings by itself. */
  readonly isNew?: boolean;
  /** The profile of the machine that it has, as `kerf machine use` names it. */
  readonly machine?: string;
  /** The controller that it drives, as `--machine` names it. */
  readonly controller?: string;
  /** Other machines that it serves at ports of their own, named in the same way. */
  readonly also?: readonly string[];
  /** Seconds of machine time in a second. */
  readonly rate?: number;
  /** Pages may hear nothing for a while, because their link is tested. */
  readonly isDeaf?: boolean;
  /** It writes no file longer than so many kilobytes, as on a full disk. */
  readonly mostKilobytes?: number;
  /** Delay of all that the server tells a page, milliseconds. */
  readonly lagMs?: number;
}

/** Waits for the line that tells the address. */
function addressOf(server: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let said = "";
    const hear = (data: Buffer) => {
      said += data.toString();
      const found = /http:\/\/\S+/.exec(said)?.[0];
      if (found) resolve(found);
    };
    server.stdout?.on("data", hear);
    server.stderr?.on("data", hear);
    server.on("exit", (code) => reject(new Error(`kerf serve ended with ${code}: ${said}`)));
    server.on("error", reject);
  });
}

/** Delay of all that the server tells a page, milliseconds: tests must not hurry before it. */
const usualLagMs = Number(process.env.KERF_LAG_MS ?? 0);

async function delayed(page: Page, lagMs: number): Promise<void> {
  if (lagMs === 0) return;
  await page.routeWebSocket(/\/ws$/, (link) => {
    const server = link.connectToServer();
    server.onMessage((message) => void setTimeout(() => link.send(message), lagMs));
  });
}

/** The folder of parts and data, with all that is in it at the start. */
function folderOf({ folder: kept, parts = [], machine, isNew }: WorkshopOptions): string {
  const folder = kept ?? mkdtempSync(join(tmpdir(), "kerf-console-"));
  for (const part of parts) {
    copyFileSync(join(root, "examples", part), join(folder, part.split("/").at(-1) ?? part));
  }
  if (machine) execFileSync(kerf, ["machine", "--data", folder, "use", machine]);
  // What an earlier server left is for the next one alone.
  const isFirst = !isNew && !existsSync(join(folder, "journal.db"));
  if (isFirst) execFileSync(kerf, ["set", "--data", folder, "uMachineSetUp=done"]);
  return folder;
}

export async function openWorkshop(options: WorkshopOptions = {}): Promise<Workshop> {
  const folder = folderOf(options);
  const file = options.open ? [options.open] : [];
  const rate = String(options.rate ?? 1);
  const listen = options.listen ?? `${options.lan ? "0.0.0.0" : "127.0.0.1"}:0`;
  const places = ["--listen", listen, "--parts", folder, "--data", folder, "--rate", rate];
  const lan = options.lan ? ["--lan"] : [];
  const only = options.drawingOnly ? ["--drawing-only"] : [];
  const told = options.webhook ? ["--webhook", options.webhook] : [];
  const begins = options.line ? ["sb3", options.line, "--console"] : ["serve", ...file];
  const driven = options.controller ? ["--machine", options.controller] : [];
  const others = (options.also ?? []).flatMap((name) => ["--also", name]);
  const served = [kerf, ...begins, ...places, ...lan, ...only, ...told, ...driven, ...others];
  const most = options.mostKilobytes;
  const bounded = most ? ["bash", "-c", `ulimit -f ${most}; exec "$0" "$@"`] : [];
  const [program = kerf, ...words] = [...bounded, ...served];
  const server = spawn(program, words, { cwd: folder });
  const wayIn = await addressOf(server);
  const { origin: address, searchParams } = new URL(wayIn);
  const token = searchParams.get("token");
  const browser = await browserHere();
  const mistakes: string[] = [];
  const pages: Page[] = [];
  const ended = async (signal: NodeJS.Signals) => {
    if (server.exitCode !== null || server.signalCode !== null) return;
    const gone = new Promise((done) => server.once("exit", done));
    server.kill(signal);
    await gone;
  };
  const left = async () => {
    openWorkshops.delete(workshop);
    await Promise.all(pages.map((page) => page.close()));
    if (openWorkshops.size === 0) await closeOthers();
  };
  const workshop: Workshop = {
    address,
    shows: token === null ? {} : { authorization: `Bearer ${token}` },
    parts: folder,
    browser,
    pages,
    isDeaf: options.isDeaf === true,
    mistakes,
    async page(size = { width: 1280, height: 720 }, hasTouch = false) {
      const page = await freshPage(address, { viewport: size, hasTouch });
      page.setDefaultTimeout(patienceMs);
      page.on("pageerror", (error) => mistakes.push(error.message));
      page.on("console", (message) => {
        if (message.type() === "error")
          mistakes.push(`${message.text()} ${message.location().url}`);
      });
      pages.push(page);
      await delayed(page, options.lagMs ?? usualLagMs);
      await page.goto(wayIn);
      return page;
    },
    async kill() {
      await ended("SIGKILL");
      await left();
    },
    async close() {
      await left();
      // It puts down what it knows before it goes.
      await ended("SIGTERM");
      rmSync(folder, { recursive: true, force: true });
    },
  };
  openWorkshops.add(workshop);
  return workshop;
}
