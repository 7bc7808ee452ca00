import { describe, expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import { states } from "../../tests/standin/states";
import { seconds } from "../units/quantity";
import { message } from "../units/testing";
import type { Finding, LastRun, Opened, Snapshot } from "../wire/messages";
import { fileStatus, progressOf } from "./fileStatus";

const opened = firstSnapshot.opened as Opened;
const now = new Date(2026, 10, 24, 15, 0);
const ran = (ended: string, line: number, seconds: number) =>
  message<LastRun>({ ended, at: new Date(2026, 10, 24, 14, 3).getTime() / 1000, line, seconds });

const error = (line: number, file = ""): Finding => ({
  level: "error",
  code: "S002",
  file,
  line,
  column: 1,
  length: 3,
  message: "unknown command FOO",
  hint: "",
});

/** A line that somebody typed. */
const typed = (ended: string | null): Snapshot["job"] => {
  const job = states.running?.job;
  return job ? { ...job, hash: null, command: "MX,3", ended } : null;
};

const told = (change: Partial<Opened>, other: Partial<Snapshot> = {}): Snapshot => ({
  ...firstSnapshot,
  ...other,
  opened: { ...opened, ...change },
});

describe("how the open file stands", () => {
  const words = (snapshot: Snapshot) => fileStatus(snapshot, now).words;
  const since = (ended: string, line: number) => told({ ran: ran(ended, line, 75) });
  const interrupted = {
    file: opened.name,
    hash: opened.content,
    line: 9,
    text: "",
    stopped: true,
    moved: false,
  };
  it.each<[string, Snapshot]>([
    ["", { ...firstSnapshot, opened: null }],
    ["finished", { ...firstSnapshot, opened: null, job: typed("ok") }],
    ["running, line 14", told({}, { job: typed(null) })],
    ["ready, never run", told({}, { job: typed("ok") })],
    ["ready, never run", told({})],
    ["being checked", told({ preview: { state: "working" } })],
    ["1 mistake: see line 12", told({ broken: true, findings: [error(12)] })],
    [
      "2 mistakes: see line 3 of a.sbp",
      told({ broken: true, findings: [error(3, "a.sbp"), error(4)] }),
    ],
    ["its preview ends at line 5", told({ findings: [error(5)] })],
    ["running, line 13", told({}, states.running)],
    ["held, line 13", told({}, states.held)],
    ["running, path 13", told({ kind: "job" }, states.running)],
    ["finished at 14:03", since("ok", 20)],
    ["failed behind line 7 at 14:03", since("failed", 7)],
    ["interrupted behind line 9", told({}, { interrupted })],
    ["ready, never run", told({ content: "another" }, { interrupted })],
    ["ready, never run", told({ name: "other.sbp" }, { interrupted })],
  ])("%s", (wanted, snapshot) => expect(words(snapshot)).toBe(wanted));

  it("leads to the first mistake", () => {
    const { place, look } = fileStatus(told({ broken: true, findings: [error(12), error(14)] }));
    expect([place, look]).toEqual([{ file: opened.name, line: 12 }, "error"]);
  });

  it.each<[number | undefined, Partial<Opened>]>([
    [7, { kind: "program" }],
    [undefined, { kind: "job" }],
  ])("leads to line %s behind which it failed", (line, change) => {
    const { place } = fileStatus(told({ ...change, ran: ran("failed", 7, 1) }));
    expect(place?.line).toBe(line);
  });
});

describe("how far it is", () => {
  const job = states.running?.job ?? null;
  it("is that of the file that ran, and of no other", () => {
    const done = { ...firstSnapshot.motion, progress: 1 };
    const over = job && { ...job, ended: "ok" };
    expect(progressOf(told({}, { job: over, motion: done })).part).toBe(1);
    expect(progressOf(told({ hash: "other" }, { job: over, motion: done })).part).toBe(0);
  });
  it("tells the time so far, and behind the end the time that it took", () => {
    expect(progressOf(told({}, states.running)).spent).toBe("so far 0:14");
    expect(progressOf(told({ ran: ran("ok", 0, 75) })).spent).toBe("took 1:15");
    expect(progressOf(told({})).spent).toBeUndefined();
  });
  it("is not told of a file whose plan ends at an error", () => {
    const over = job && { ...job, ended: "failed" };
    const done = { ...firstSnapshot.motion, progress: 1 };
    const shown = progressOf(told({ findings: [error(5)] }, { job: over, motion: done }));
    expect(shown.part).toBeUndefined();
  });
  it("is not told without a plan", () => {
    const typed = job && { ...job, hash: null, seconds: seconds(0), command: "MX,3" };
    const shown = progressOf(told({}, { job: typed }));
    expect(shown).toMatchObject({ name: "MX,3", part: undefined, seconds: undefined });
    const ends = { broken: true, findings: [error(3)] };
    expect(progressOf(told(ends)).seconds).toBeUndefined();
  });
});
