import { readFileSync } from "node:fs";
import { expect, it, vi } from "vitest";
import { mostBytes } from "../link/send";
import type { Problem } from "../wire/messages";
import { stageText, Uploads, type Ways } from "./uploads";

const file = (name: string, bytes = 3) => new File(["x".repeat(bytes)], name);

/** Progress of each, in words. */
const words = (uploads: Uploads) => uploads.list.get().map((one) => stageText(one));

const sends = (send: Ways["send"], moves = () => false) => new Uploads({ send, moves });

it("the longest file is the longest that the server takes", () => {
  const server = new URL("../../../crates/server/src/http/bodies.rs", import.meta.url);
  const told = /pub const FILE: usize = (\d+) << (\d+);/.exec(readFileSync(server, "utf8"));
  expect(mostBytes).toBe(Number(told?.[1]) << Number(told?.[2]));
});

it("a file that is too large is not tried, and the words say how large it may be", () => {
  const send = vi.fn<Ways["send"]>();
  const uploads = sends(send);
  uploads.add("", [{ name: "a.sbp", size: mostBytes + 1 } as File]);
  expect(words(uploads)).toEqual(["is not sent: it has 129 MB, and 128 MB is the most"]);
  expect(send).not.toHaveBeenCalled();
});

it("one after the other is sent, below the folder that is shown", async () => {
  const done: ((problem: Problem | null) => void)[] = [];
  const names: string[] = [];
  const uploads = sends((name) => {
    names.push(name);
    return new Promise((resolve) => done.push(resolve));
  });
  uploads.add("x", [file("a.sbp"), file("b.sbp")]);
  await vi.waitFor(() => expect(names).toEqual(["x/a.sbp"]));
  expect(words(uploads)).toEqual(["0 B of 3 B are sent", "waits for the one before it"]);
  done[0]?.({ why: "full", text: "the disk is full" });
  await vi.waitFor(() => expect(names).toEqual(["x/a.sbp", "x/b.sbp"]));
  done[1]?.(null);
  await vi.waitFor(() =>
    expect(words(uploads)).toEqual(["is not sent: the disk is full", "is in the part folder, 3 B"]),
  );
});

it("what is not over is stopped when its list is closed, and its name is given", async () => {
  let signal: AbortSignal | undefined;
  const uploads = sends((_, __, sending) => {
    signal = sending.signal;
    return new Promise(() => {});
  });
  uploads.add("", [file("a.sbp"), file("b.sbp")]);
  await vi.waitFor(() => expect(signal?.aborted).toBe(false));
  expect(uploads.close()).toEqual(["a.sbp", "b.sbp"]);
  expect(signal?.aborted).toBe(true);
  expect(uploads.close()).toEqual([]);
});

it("a machine that moves is waited for, as the page knows it or as the server says", async () => {
  vi.useFakeTimers();
  let moves = true;
  const answers: (Problem | null)[] = [{ why: "state", text: "the machine moves" }, null];
  const send = vi.fn<Ways["send"]>(async () => answers.shift() ?? null);
  const uploads = sends(send, () => moves);
  uploads.add("", [file("a.sbp")]);
  await vi.advanceTimersByTimeAsync(2500);
  expect(send).not.toHaveBeenCalled();
  expect(words(uploads)[0]).toMatch(/^held: the machine moves/);
  moves = false;
  await vi.advanceTimersByTimeAsync(1000);
  expect(words(uploads)[0]).toMatch(/^held: the machine moves/);
  await vi.advanceTimersByTimeAsync(1000);
  expect(words(uploads)).toEqual(["is in the part folder, 3 B"]);
  vi.useRealTimers();
});
