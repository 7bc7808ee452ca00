/** The browsers of a test run: one for each worker, started once; each test file opens pages of its own in it. */

import { existsSync } from "node:fs";
import { type Browser, type BrowserContext, chromium, type Page } from "playwright-core";
import { inject } from "vitest";
import type { TestProject } from "vitest/node";

declare module "vitest" {
  interface ProvidedContext {
    /** Addresses at which the browsers listen, one a worker. */
    browsers: readonly string[];
  }
}

const flags = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  // Distributions turn it on, where a processor draws that takes longer.
  "--disable-gpu-rasterization",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  // Pages of one profile share a process: to start one, and to compile the page in it, takes half of a page's time.
  "--process-per-site",
];

/** The first of these browsers that is installed: the one without windows starts and draws faster. */
function installed(): string {
  const known = ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"];
  return process.env.CHROMIUM ?? known.find(existsSync) ?? "chromium";
}

/** Starts them before the first test; what is returned ends them. */
export async function setup(project: TestProject): Promise<() => Promise<void>> {
  const executablePath = installed();
  const workers = Array.from({ length: project.config.maxWorkers });
  const servers = await Promise.all(
    workers.map(() => chromium.launchServer({ executablePath, args: flags })),
  );
  const browsers = servers.map((server) => server.wsEndpoint());
  project.provide("browsers", browsers);
  return async () => {
    await Promise.all(servers.map((server) => server.close()));
  };
}

let connected: Promise<Browser> | undefined;

/** The browser of this worker: all files of tests that it runs work in it. */
export function browserHere(): Promise<Browser> {
  const browsers = inject("browsers");
  const worker = Number(process.env.VITEST_POOL_ID ?? 1) - 1;
  const browser = browsers[worker % browsers.length];
  if (browser === undefined) throw new Error("no browser was started");
  connected ??= chromium.connect(browser);
  return connected;
}

export interface Screen {
  readonly viewport: { readonly width: number; readonly height: number };
  readonly hasTouch: boolean;
}

/** Profiles that nobody works in, and all that were made. */
const [idle, ours] = [new Map<boolean, BrowserContext[]>(), new Set<BrowserContext>()];

/** A page of a browser that has never seen this address. It has its profile to itself, until it is closed. */
export async function freshPage(address: string, { viewport, hasTouch }: Screen): Promise<Page> {
  const waiting = idle.get(hasTouch) ?? [];
  idle.set(hasTouch, waiting);
  const context = waiting.pop() ?? (await newProfile(hasTouch));
  const page = await context.newPage();
  await page.setViewportSize(viewport);
  await forget(page, address);
  page.once("close", () => waiting.push(context));
  return page;
}

/**
 * A profile with a window: the empty page in it keeps the window and the process of this computer's pages open, which
 * take longer to open than all else.
 */
async function newProfile(hasTouch: boolean): Promise<BrowserContext> {
  const context = await (await browserHere()).newContext({ hasTouch });
  ours.add(context);
  const empty = await context.newPage();
  await empty.route("**", (route) => route.fulfill({ contentType: "text/html", body: "" }));
  await empty.goto("http://127.0.0.1/");
  return context;
}

/** Takes all that an address left behind out of the page's profile. */
async function forget(page: Page, origin: string): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send("Storage.clearDataForOrigin", { origin, storageTypes: "all" });
  await session.detach();
  // Cookies are those of a host, whatever its port.
  await page.context().clearCookies();
}

/** Closes what a file of tests opened besides. */
export async function closeOthers(): Promise<void> {
  const others = (await browserHere()).contexts().filter((context) => !ours.has(context));
  await Promise.all(others.map((context) => context.close()));
}
