/** The file that is open and the job that runs it. */

import type { Action, World } from "./action";
import { ask, drive } from "./ask";
import { unless, unlessReady } from "./machine";

const openedOf = ({ shown }: World) => shown.snapshot?.opened ?? undefined;

/** Why the open file cannot be started. */
function notPreviewed(world: World): string | undefined {
  const opened = openedOf(world);
  if (!opened) return "Open a file first.";
  switch (opened.preview.state) {
    case "working":
      return "Its preview is being made.";
    case "failed":
      return opened.preview.why;
    case "ready":
      return undefined;
  }
}

const whenReady = (world: World) => notPreviewed(world) ?? unlessReady(world);

const run = (step: boolean) => (world: World) => {
  const opened = openedOf(world);
  if (opened) void drive(world, { do: "run", hash: opened.hash, step });
};

export const start: Action = {
  id: "job.start",
  title: "Start",
  section: "job",
  refused: whenReady,
  run: run(false),
};

export const singleStep: Action = {
  id: "job.step",
  title: "Single step",
  section: "job",
  refused: whenReady,
  run: run(true),
};

export const closeFile: Action = {
  id: "job.close",
  title: "Close the file",
  section: "file",
  refused: (world) =>
    openedOf(world) ? unless(["idle", "alarm"], "It is running.")(world) : "No file is open.",
  run: (world) => void ask(world, { do: "close" }),
};

export const clearPrinted: Action = {
  id: "job.clearPrinted",
  title: "Empty the print window",
  section: "job",
  run: (world) => void ask(world, { do: "clearPrinted" }),
};

export const jobActions: readonly Action[] = [start, singleStep, closeFile, clearPrinted];
