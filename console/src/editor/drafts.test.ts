import { ChangeSet } from "@codemirror/state";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { draftOf, edited, newFile } from "./document";
import { DraftKeeper } from "./drafts";

/** Requests to the server: the method and the text, or the address of a draft that ended. */
let sent: string[];
let refuses: boolean;

beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  refuses = false;
  vi.stubGlobal("fetch", async (address: string, init: RequestInit) => {
    if (refuses) return new Response("the disk is full", { status: 500 });
    sent.push(init.body ? JSON.parse(String(init.body)).text : address);
    return new Response("null");
  });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function draft(name: string, typed: string) {
  const changes = ChangeSet.of({ from: 0, insert: typed }, 0);
  return draftOf(edited({ ...newFile, name }, changes.apply(newFile.text), changes));
}

it("sends what was typed last, within half a second", async () => {
  const keeper = new DraftKeeper(() => undefined);
  for (const text of ["M", "MX", "MX,1"]) keeper.keep(draft("a.sbp", text));
  await vi.advanceTimersByTimeAsync(400);
  expect(sent).toEqual(["MX,1"]);
});

it("keeps files apart, and ends what was saved", async () => {
  const keeper = new DraftKeeper(() => undefined);
  keeper.keep(draft("a.sbp", "MX,1"));
  keeper.keep(draft("b.sbp", "MY,1"));
  keeper.end("a.sbp");
  await vi.advanceTimersByTimeAsync(400);
  expect(sent[0]).toMatch(/^\/api\/texts\?name=a.sbp&page=./);
  expect(sent.slice(1)).toEqual(["MY,1"]);
});

it("tells once when the server refuses, and tries again", async () => {
  const told: string[] = [];
  const keeper = new DraftKeeper((text) => told.push(text));
  refuses = true;
  keeper.keep(draft("a.sbp", "MX,1"));
  await vi.advanceTimersByTimeAsync(3000);
  expect(told).toHaveLength(1);
  expect(told[0]).toContain("the disk is full");
  refuses = false;
  await vi.advanceTimersByTimeAsync(3000);
  expect(sent).toEqual(["MX,1"]);
});

it("does not wait for ever for a server that refuses, and knows what it still has", async () => {
  const keeper = new DraftKeeper(() => undefined);
  refuses = true;
  keeper.keep(draft("a.sbp", "MX,1"));
  const settled = keeper.settled();
  await vi.advanceTimersByTimeAsync(2000);
  await settled;
  expect(keeper.waiting("a.sbp")?.text).toBe("MX,1");
  expect(keeper.waiting("b.sbp")).toBe(undefined);
});
