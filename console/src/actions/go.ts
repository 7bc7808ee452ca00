/** Actions that change the view: screens, sheets, themes, faces. */

import { type Route, routes } from "../app/routes";
import type { Sheet } from "../app/screen";
import { busy, filesOnly, refusal } from "../keypad/refusal";
import { themeNames, themes } from "../theme/theme";
import { t } from "../words/words";
import type { Action } from "./action";
import { drive } from "./ask";

const routeActions = routes.map(
  ({ path, title }): Action => ({
    id: `go.${title.toLowerCase()}`,
    title: t("Go to {0}", title),
    section: "go",
    run: ({ screen }) => screen.go(path satisfies Route),
  }),
);

const sheetAction = (sheet: Sheet, title: string, keys: readonly string[]): Action => ({
  id: `sheet.${sheet.kind}`,
  title,
  section: "go",
  keys,
  // A letter is typed where somebody types; other keys mean a sheet wherever they are pressed.
  everywhere: keys.every((key) => key.length > 1),
  // Each one that is opened is another: what closes an earlier one leaves it open.
  run: ({ screen }) => screen.open({ ...sheet }),
});

export const openFiles = sheetAction({ kind: "files" }, t("Open a file"), ["Ctrl+O"]);
/** The keypad is a command (SK): every page shows it. Where it cannot open yet, its sheet says why. */
export const openKeypad: Action = {
  ...sheetAction({ kind: "keypad" }, t("Keypad"), ["k"]),
  keysTell: true,
  refused: ({ shown }) => {
    const why = refusal(shown);
    return why === busy || why === filesOnly ? why : undefined;
  },
  run: (world) => {
    if (refusal(world.shown) === undefined) void drive(world, { do: "command", line: "SK" });
    else world.screen.open({ kind: "keypad" });
  },
};
export const openScratch = sheetAction({ kind: "scratch" }, t("Scratch pad"), ["i"]);
export const openCalculator: Action = {
  id: "sheet.calculator",
  title: t("Calculator"),
  section: "go",
  keys: ["F10"],
  everywhere: true,
  run: ({ screen }) => screen.calculate(true),
};
/** The hand console of the machine, with its keys on the keyboard as long as it is shown. */
export const openHandConsole: Action = {
  id: "sheet.handConsole",
  title: t("Hand console"),
  section: "go",
  refused: ({ shown }) =>
    shown.snapshot?.drawingOnly ? t("Only drawings are worked on here.") : undefined,
  run: ({ screen }) => screen.showHandConsole(!screen.get().handConsole),
};
export const openValues = sheetAction({ kind: "values" }, t("Values and variables"), [
  "Ctrl+Shift+V",
]);
export const openNudge = sheetAction({ kind: "nudge" }, t("Nudge the workpiece"), ["Ctrl+Shift+N"]);
export const openMoveTo = sheetAction(
  { kind: "moveTo" },
  t("Move the tool to a place, or home"),
  [],
);
export const openRecorder = sheetAction({ kind: "recorder" }, t("Recorded commands"), []);
export const openTools = sheetAction({ kind: "tools" }, t("Virtual tools"), []);
export const openInputs = sheetAction({ kind: "inputs" }, t("Inputs of the machine"), []);
export const openPorts = sheetAction({ kind: "ports" }, t("Ports of the card: diagnostics"), []);
/** Zero points that a controller keeps, seen, set and chosen. */
const openZeros: Action = {
  ...sheetAction({ kind: "zeros" }, t("Zero points of the controller: G54 to G59.3"), []),
  refused: ({ shown }) =>
    shown.snapshot?.zeros.length ? undefined : t("The machine keeps no zero points."),
};
/** Settings that a controller keeps by number, seen, changed, kept and compared. */
const openControllerSettings: Action = {
  ...sheetAction(
    { kind: "controllerSettings" },
    t("Settings of the controller: see, change, back up, compare"),
    [],
  ),
  refused: ({ shown }) =>
    shown.snapshot?.controllerSettings.length
      ? undefined
      : t("The machine keeps no settings by number."),
};
/** Files that the controller keeps on a card of its own; its sheet says why where there is none. */
const openControllerCard = sheetAction(
  { kind: "controllerCard" },
  t("Card of the controller: list, upload, run, follow"),
  [],
);
/** Opens the lines that were sent to the controller and its answers. */
const openControllerLines = sheetAction(
  { kind: "controllerLines" },
  t("Console of the controller: what is sent and answered"),
  [],
);
/** The spindle turns in steps of speed and time before it cuts. */
const openWarmUp = sheetAction(
  { kind: "warmUp" },
  t("Spindle warm-up: steps of speed and time"),
  [],
);
/** Tools by their numbers, where they are changed and measured. */
export const openToolTable = sheetAction(
  { kind: "toolTable" },
  t("Tools by their numbers: lengths, changing and measuring them"),
  [],
);
/** Zero set by touch: plates, corners, bores, the angle of the material. */
const openProbe = sheetAction(
  { kind: "probe" },
  t("Probe: find a place by touch, set zero there"),
  [],
);
/** A surface that is not flat: probed on a grid, and followed by what is cut. */
const openHeightMap = sheetAction(
  { kind: "heightMap" },
  t("Height map: probe a surface, cut along it"),
  [],
);
const openSurfacing = sheetAction(
  { kind: "surfacing" },
  t("Surfacing: plane a board or the table"),
  [],
);
/** Lengths and angles that were measured become settings. */
const openTuning = sheetAction(
  { kind: "tuning" },
  t("Steps per millimetre and squareness, from what was measured"),
  [],
);
/** A board with step queues that becomes the controller of the machine, question by question. */
const openWiring = sheetAction({ kind: "wiring" }, t("Wire a board of a printer"), []);
/** Inputs and outputs of the open file beside its motion. */
export const openTiming: Action = {
  ...sheetAction({ kind: "timing" }, t("Timing chart"), []),
  refused: ({ shown }) => (shown.snapshot?.opened ? undefined : t("Open a file first.")),
};
export const openSetup = sheetAction({ kind: "setup" }, t("Set up the machine, step by step"), []);
const openKeys = sheetAction({ kind: "keys" }, t("Keys of actions"), []);
const openHistory = sheetAction({ kind: "history" }, t("History of runs"), []);
const openToDo = sheetAction({ kind: "todo" }, t("Jobs to do"), []);
const openSamples = sheetAction({ kind: "samples" }, t("Sample answers of the open file"), []);
export const openMacros = sheetAction({ kind: "macros" }, t("Macros: commands of one's own"), []);
export const openPalette = sheetAction({ kind: "palette" }, t("Every action"), ["Ctrl+K"]);

const themeActions = themes.map(
  (theme): Action => ({
    id: `theme.${theme}`,
    title: t("Theme: {0}", themeNames[theme]),
    section: "view",
    run: ({ screen }) => screen.wear(theme),
  }),
);

const faceActions: readonly Action[] = [
  {
    id: "face.easy",
    title: t("Face: EASY, buttons only"),
    section: "view",
    run: ({ screen }) => screen.face("easy"),
  },
  {
    id: "face.full",
    title: t("Face: FULL, menus and command line"),
    section: "view",
    run: ({ screen }) => screen.face("full"),
  },
];

export const goActions: readonly Action[] = [
  ...routeActions,
  openFiles,
  openKeypad,
  openScratch,
  openCalculator,
  openHandConsole,
  openNudge,
  openMoveTo,
  openValues,
  openRecorder,
  openInputs,
  openPorts,
  openZeros,
  openControllerSettings,
  openControllerCard,
  openControllerLines,
  openWarmUp,
  openToolTable,
  openProbe,
  openHeightMap,
  openSurfacing,
  openTuning,
  openWiring,
  openTools,
  openTiming,
  openSetup,
  openKeys,
  openHistory,
  openToDo,
  openSamples,
  openMacros,
  openPalette,
  ...themeActions,
  ...faceActions,
];
