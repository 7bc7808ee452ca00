import { defineConfig } from "vitest/config";

/** Tests in a real browser against the real server; `npm run browser`. */
export default defineConfig({
  test: {
    include: ["**/*.test.ts"],
    // Hooks in the order of their files: what is shown is told before a test closes its pages.
    setupFiles: ["tests/browser/aftermath.ts"],
    sequence: { hooks: "list" },
    // What a test waits for comes when it comes: these only end one that waits for ever.
    testTimeout: 240_000,
    hookTimeout: 120_000,
    expect: { poll: { timeout: 40_000, interval: 50 } },
    globalSetup: ["tests/browser/browsers.ts"],
    // Each with a browser, a server and a machine of its own: while some wait for their machine another works.
    maxWorkers: 3,
    // What the files share is loaded once a worker.
    isolate: false,
  },
});
