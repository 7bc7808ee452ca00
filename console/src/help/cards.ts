/** Questions of newcomers, each with the steps of an answer and the place of the book that tells more. */

import { t } from "../words/words";

export interface Card {
  readonly question: string;
  readonly steps: readonly string[];
  /** The page of the book, and the heading on it. */
  readonly place: string;
}

export const cards: readonly Card[] = [
  {
    question: t("How do I cut my first part?"),
    steps: [
      t("Open a sample job below."),
      t("Press Arm."),
      t("Press Start and answer what the program asks."),
    ],
    place: "getting-started",
  },
  {
    question: t("How do I bring in a file of my own?"),
    steps: [
      t("Drop it anywhere on the page, or press Choose file, then Upload."),
      t("One file is opened at once; of several, press Open at the one that is meant."),
    ],
    place: "console#what-is-kept-of-your-work",
  },
  {
    question: t("How do I stop the machine?"),
    steps: [t("Press STOP, or the space bar."), t("Hold only pauses: Resume goes on.")],
    place: "promises#stop",
  },
  {
    question: t("How do I move the tool by hand?"),
    steps: [
      t("Press Move tool."),
      t("Choose a step, or While held."),
      t("Press an arrow for as long as it is to move."),
    ],
    place: "console#the-keypad",
  },
  {
    question: t("How do I set zero?"),
    steps: [
      t("Move the tool to the corner of the stock."),
      t("Press Zero beside X and Y."),
      t("Touch the stock and press Zero beside Z."),
    ],
    place: "frames",
  },
  {
    question: t("How do I set Z with a touch plate?"),
    steps: [
      t("Wire the plate to an input."),
      t("Lay it on the stock below the tool."),
      t("Choose Probe in the list of actions, and Plate or surface."),
    ],
    place: "machine#custom-cuts",
  },
  {
    question: t("How do I work in millimetres?"),
    steps: [t("Go to Settings."), t("Search for inch."), t("Choose mm at Units.")],
    place: "getting-started#inches-or-millimetres",
  },
  {
    question: t("How do I home the machine?"),
    steps: [
      t("In Settings, Homing, tell which axes have a switch."),
      t("Open Move the tool to, and press Home."),
    ],
    place: "machine#homing",
  },
  {
    question: t("How do I set up a new machine?"),
    steps: [
      t("Go to Settings and press Set up."),
      t("Answer the six steps."),
      t("Save the settings as a backup."),
    ],
    place: "machine#configuration",
  },
  {
    question: t("How do I back up my settings?"),
    steps: [
      t("Go to Settings."),
      t("Press Save settings: a text file is downloaded."),
      t("Load settings brings it back."),
    ],
    place: "machine#configuration",
  },
  {
    question: t("How do I connect a real controller?"),
    steps: [
      t("Close other senders."),
      t("Start Kerf with the port of the controller."),
      t("Try the moves by hand before a job."),
    ],
    place: "real-controller#before-anything-moves",
  },
  {
    question: t("How do I cut slower or faster?"),
    steps: [t("Drag Feed while it cuts."), t("To change it for good, press Move beside Speeds.")],
    place: "running#holding-resuming-another-feed",
  },
  {
    question: t("How do I open a DXF or SVG?"),
    steps: [
      t("Drop it on the page, or go to Draw and press Open."),
      t("Look whether all of it was read: notes stand at the right."),
    ],
    place: "drawings#what-is-read",
  },
  {
    question: t("How do I make a tool path?"),
    steps: [
      t("Select the shapes in Draw."),
      t("Set how their layer is cut: side, depth, tool."),
      t("Press Make the part program."),
    ],
    place: "drawings#tool-paths",
  },
  {
    question: t("How do I clear a pocket?"),
    steps: [
      t("Select the closed shape in Draw."),
      t("Press Pocket and enter the tool's diameter."),
      t("Set the depth of its layer."),
    ],
    place: "drawings#pockets",
  },
  {
    question: t("How do I go on after a stop or a power cut?"),
    steps: [
      t("Look that tool and stock are where they were."),
      t("Press Arm."),
      t("Take the job up where it was interrupted."),
    ],
    place: "running#when-the-power-fails",
  },
  {
    question: t("How do I run G-code?"),
    steps: [
      t("Open the .nc file as any other."),
      t("Read the notes: what Kerf does not know is told before the start."),
    ],
    place: "gcode",
  },
  {
    question: t("How do I find a mistake in a part file?"),
    steps: [
      t("Press the words beside the name of the file: the line opens in the editor."),
      t("Go line by line, and watch variables."),
    ],
    place: "console#the-editor",
  },
  {
    question: t("How do I use a tablet or phone?"),
    steps: [
      t("Start Kerf with --lan."),
      t("Go to Settings, Devices, and show a code."),
      t("Open the address on the phone and type the code."),
    ],
    place: "serve#other-devices",
  },
  {
    question: t("How do I see how long a job takes?"),
    steps: [
      t("Open it: planned time stands below the picture."),
      t("Timing shows what switches when."),
    ],
    place: "time",
  },
];
