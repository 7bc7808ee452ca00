import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

/** Where `kerf serve` listens; `npm run dev` hands the socket and the files on to it. */
const server = process.env.KERF_ADDRESS ?? "http://127.0.0.1:8710";

export default defineConfig({
  plugins: [react()],
  // The server puts a new number in its place whenever it hands the page out.
  html: { cspNonce: "__KERF_NONCE__" },
  build: { target: "es2022", assetsInlineLimit: 0, chunkSizeWarningLimit: 800 },
  worker: { format: "es" },
  server: { proxy: { "/api": { target: server }, "/ws": { target: server, ws: true } } },
  test: { include: ["src/**/*.test.ts"], environment: "node" },
});
