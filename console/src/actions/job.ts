/** The file that is open and the job that runs it. */

import { errorsOf, mistakesText, placeOf } from "../operator/fileStatus";
import type { Snapshot } from "../wire/messages";
import { serverWords } from "../words/server";
import { t } from "../words/words";
import { type Action, attempt, type World } from "./action";
import { ask, drive } from "./ask";
import { unless, unlessReady, whenIdle } from "./machine";

const openedOf = ({ shown }: World) => shown.snapshot?.opened ?? undefined;

/** Tells why the open file cannot be started. */
function notPreviewed(world: World): string | undefined {
  const opened = openedOf(world);
  if (!opened) return t("Open a file first.");
  switch (opened.preview.state) {
    case "working":
      return t("It is being checked: its preview is made.");
    case "failed":
      return opened.preview.why;
    case "ready":
      return opened.broken ? mistakesText(opened) : undefined;
  }
}

/** Goes to the first mistake of the open file. */
function showMistake(world: World): void {
  const opened = openedOf(world);
  const place = opened?.broken && placeOf(errorsOf(opened)[0], opened);
  if (place) world.screen.showLine(place);
}

/** A machine that hurts nobody is armed by starting. */
const arms = ({ shown: { snapshot } }: World): boolean =>
  (snapshot?.machine.offers.startArms && !snapshot.machine.armed && !draws(snapshot)) ?? false;

/** A part file in preview is only drawn, and needs no armed machine. */
const draws = ({ machine, opened }: Snapshot): boolean =>
  machine.mode === "preview" && opened?.kind === "program";

const whenReady = (world: World) => {
  const { snapshot } = world.shown;
  if (snapshot?.machine.mode === "preview" && snapshot.opened?.kind === "job") {
    return t("In preview only part files are drawn. Choose Move mode first.");
  }
  const still = arms(world) || (snapshot !== null && draws(snapshot));
  return notPreviewed(world) ?? (still ? whenIdle(world) : unlessReady(world));
};

/** The open job waits, paused or before its second Start: Start goes on with it. */
const waits = ({ shown: { snapshot } }: World): boolean =>
  snapshot?.asked?.kind === "paused" && snapshot.job?.hash === snapshot.opened?.hash;

const whenStartable = (world: World) => {
  if (!waits(world)) return whenReady(world);
  return world.shown.snapshot?.machine.armed || arms(world)
    ? undefined
    : t("Arm the machine first.");
};

const run = (step: boolean) => async (world: World) => {
  const opened = openedOf(world);
  if (!opened || (arms(world) && !(await drive(world, { do: "arm" })))) return;
  await drive(world, { do: "run", hash: opened.hash, step });
};

export const start: Action = {
  id: "job.start",
  title: t("Start"),
  section: "job",
  refused: whenStartable,
  mends: showMistake,
  run: (world) => void run(false)(world),
};

export const singleStep: Action = {
  id: "job.step",
  title: t("Single step"),
  section: "job",
  refused: whenReady,
  mends: showMistake,
  run: (world) => void run(true)(world),
};

/** The Start key of jobs. Where it starts nothing it says why. */
export const startKey: Action = {
  id: "job.startKey",
  title: t("Start the job, or go on with it"),
  section: "job",
  keys: ["F10"],
  when: (world) =>
    world.screen.get().route === "/" && (openedOf(world)?.kind ?? "program") !== "program",
  everywhere: true,
  run: (world) => attempt(start, world),
};

/** Makes the tool path of a drawing anew, though its job was changed by hand. */
export const machineAnew: Action = {
  id: "job.anew",
  title: t("Make the tool path anew"),
  section: "job",
  refused: (world) =>
    drawingOf(world) === null && !world.shown.snapshot?.drawing
      ? t("No drawing is open.")
      : undefined,
  warns: () => t("Its paths were changed by hand. Making them anew from the drawing loses that."),
  run: async (world) => {
    const act = { do: "machine", drawing: drawingOf(world), anew: true } as const;
    if (await ask(world, act)) world.screen.go("/");
  },
};

/** The drawing that is open as a file; nothing where the one on the sheet is meant. */
const drawingOf = (world: World): string | null => {
  const opened = openedOf(world);
  return world.screen.get().route === "/" && opened?.kind === "drawing" ? opened.name : null;
};

const interruptedOf = ({ shown }: World) => shown.snapshot?.interrupted ?? undefined;

/** Warnings to be read before a run goes on. */
function warnings(world: World): string {
  const interrupted = interruptedOf(world);
  const doubt = t(
    "The machine moved when Kerf ended: make sure that it is where the display says, and zero it anew if not.",
  );
  const once = t("Before the tool goes back and anything turns you are asked once more.");
  return [sentence(serverWords(interrupted?.text ?? "")), interrupted?.moved ? doubt : "", once]
    .filter((words) => words !== "")
    .join(" ");
}

const sentence = (text: string): string => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;

/** Goes on with a run that was cut short: by a stop, a killed program, a power cut. */
export const takeUp: Action = {
  id: "job.takeUp",
  title: t("Recover job"),
  section: "job",
  refused: (world) => (interruptedOf(world) ? unlessReady(world) : t("No run was cut short.")),
  warns: warnings,
  run: (world) => void drive(world, { do: "takeUp" }),
};

export const closeFile: Action = {
  id: "job.close",
  title: t("Close the file"),
  section: "file",
  refused: (world) =>
    openedOf(world) ? unless(["idle", "alarm"], t("It is running."))(world) : t("No file is open."),
  run: (world) => void ask(world, { do: "close" }),
};

export const clearPrinted: Action = {
  id: "job.clearPrinted",
  title: t("Empty the print window"),
  section: "job",
  run: (world) => void ask(world, { do: "clearPrinted" }),
};

export const jobActions: readonly Action[] = [
  startKey,
  start,
  singleStep,
  machineAnew,
  takeUp,
  closeFile,
  clearPrinted,
];
