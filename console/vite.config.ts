import { readFileSync } from "node:fs";
import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

/** Where `kerf serve` listens; `npm run dev` hands the socket and the files on to it. */
const server = process.env.KERF_ADDRESS ?? "http://127.0.0.1:8710";

/** The version of Kerf that the page is built with: that of the workspace. */
const cargo = readFileSync(new URL("../Cargo.toml", import.meta.url), "utf8");
const version = /^version = "(.+)"$/m.exec(cargo)?.[1];
if (version === undefined) throw new Error("Cargo.toml tells no version");

export default defineConfig({
  plugins: [react()],
  define: { __KERF_VERSION__: JSON.stringify(version) },
  // The server puts a new number in its place whenever it hands the page out.
  html: { cspNonce: "__KERF_NONCE__" },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 800 },
  worker: { format: "es" },
  server: { proxy: { "/api": { target: server }, "/ws": { target: server, ws: true } } },
  test: { include: ["src/**/*.test.ts"], environment: "node" },
});
