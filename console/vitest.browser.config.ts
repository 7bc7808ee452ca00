import { defineConfig } from "vitest/config";

/** Tests in a real browser against the real server; `npm run browser`. */
export default defineConfig({
  test: {
    include: ["**/*.test.ts"],
    testTimeout: 60_000,
    hookTimeout: 60_000,
    fileParallelism: false,
  },
});
