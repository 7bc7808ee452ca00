/** The browsers of a test run: one for each worker, started once; each test file opens pages of its own in it. */

import { chromium } from "playwright-core";
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
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Starts them before the first test; what is returned ends them. */
export async function setup(project: TestProject): Promise<() => Promise<void>> {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
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

/** Connects to this worker's browser. Closing the connection closes the pages that were opened over it. */
export function connect() {
  const browsers = inject("browsers");
  const worker = Number(process.env.VITEST_POOL_ID ?? 1) - 1;
  const browser = browsers[worker % browsers.length];
  if (browser === undefined) throw new Error("no browser was started");
  return chromium.connect(browser);
}
