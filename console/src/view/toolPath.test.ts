import { afterEach, expect, it, vi } from "vitest";
import { loadToolPath } from "./toolPath";

afterEach(() => vi.unstubAllGlobals());

const info = { details: [{ segments: 1, pieces: 1 }] };

/** Loads a path from a server that answers one address after the other; gives what was asked for, and what failed. */
async function loaded(...answers: Response[]): Promise<{ asked: number; failed: unknown[] }> {
  const left = [...answers];
  vi.stubGlobal("fetch", async () => left.shift() ?? Promise.reject(new Error("asked too much")));
  const failed: unknown[] = [];
  const fails = (error: unknown) => failed.push(error);
  process.on("unhandledRejection", fails);
  loadToolPath("key");
  await new Promise((done) => setTimeout(done, 20));
  process.off("unhandledRejection", fails);
  return { asked: answers.length - left.length, failed };
}

const gone = () => new Response(null, { status: 204 });

it("a preview that is outdated ends without a mistake", async () => {
  expect(await loaded(gone())).toEqual({ asked: 1, failed: [] });
  expect(await loaded(Response.json(info), gone())).toEqual({ asked: 2, failed: [] });
});

it("one that never was is a mistake", async () => {
  const { failed } = await loaded(new Response("none", { status: 404 }));
  expect(failed).toHaveLength(1);
});
