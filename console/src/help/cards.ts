/** Questions of newcomers, each with the steps of an answer and the place of the book that tells more. */

export interface Card {
  readonly question: string;
  readonly steps: readonly string[];
  /** The page of the book, and the heading on it. */
  readonly place: string;
}

export const cards: readonly Card[] = [
  {
    question: "How do I cut my first part?",
    steps: [
      "Open a sample job below.",
      "Press Arm.",
      "Press Start and answer what the program asks.",
    ],
    place: "getting-started",
  },
  {
    question: "How do I bring in a file of my own?",
    steps: [
      "Drop it anywhere on the page, or press Choose file, then Upload.",
      "Open it in the list.",
    ],
    place: "console#what-is-kept-of-your-work",
  },
  {
    question: "How do I stop the machine?",
    steps: ["Press STOP, or the space bar.", "Hold only pauses: Resume goes on."],
    place: "promises#stop",
  },
  {
    question: "How do I move the tool by hand?",
    steps: [
      "Press Move tool.",
      "Choose a step, or While held.",
      "Press an arrow for as long as it is to move.",
    ],
    place: "console#the-keypad",
  },
  {
    question: "How do I set zero?",
    steps: [
      "Move the tool to the corner of the stock.",
      "Press Zero beside X and Y.",
      "Touch the stock and press Zero beside Z.",
    ],
    place: "frames",
  },
  {
    question: "How do I set Z with a touch plate?",
    steps: [
      "Wire the plate to an input.",
      "Lay it on the stock below the tool.",
      "Choose C2 in the Expert layout.",
    ],
    place: "machine#custom-cuts",
  },
  {
    question: "How do I work in millimetres?",
    steps: ["Go to Settings.", "Search for inch.", "Choose mm at Units."],
    place: "getting-started#inches-or-millimetres",
  },
  {
    question: "How do I home the machine?",
    steps: [
      "In Settings, Homing, tell which axes have a switch.",
      "Open Move the tool to, and press Home.",
    ],
    place: "machine#homing",
  },
  {
    question: "How do I set up a new machine?",
    steps: [
      "Go to Settings and press Set up.",
      "Answer the six steps.",
      "Save the settings as a backup.",
    ],
    place: "machine#configuration",
  },
  {
    question: "How do I back up my settings?",
    steps: [
      "Go to Settings.",
      "Press Save settings: a text file is downloaded.",
      "Load settings brings it back.",
    ],
    place: "machine#configuration",
  },
  {
    question: "How do I connect a real controller?",
    steps: [
      "Close other senders.",
      "Start Kerf with the port of the controller.",
      "Try the moves by hand before a job.",
    ],
    place: "real-controller#before-anything-moves",
  },
  {
    question: "How do I cut slower or faster?",
    steps: ["Drag Feed while it cuts.", "To change it for good, press Move beside Speeds."],
    place: "running#holding-resuming-another-feed",
  },
  {
    question: "How do I open a DXF or SVG?",
    steps: [
      "Drop it on the page, or go to Draw and press Open.",
      "Look whether all of it was read: notes stand at the right.",
    ],
    place: "drawings#what-is-read",
  },
  {
    question: "How do I make a tool path?",
    steps: [
      "Select the shapes in Draw.",
      "Set how their layer is cut: side, depth, tool.",
      "Press Make the part program.",
    ],
    place: "drawings#tool-paths",
  },
  {
    question: "How do I clear a pocket?",
    steps: [
      "Select the closed shape in Draw.",
      "Press Pocket and enter the tool's diameter.",
      "Set the depth of its layer.",
    ],
    place: "drawings#pockets",
  },
  {
    question: "How do I go on after a stop or a power cut?",
    steps: [
      "Look that tool and stock are where they were.",
      "Press Arm.",
      "Take the job up where it was interrupted.",
    ],
    place: "running#when-the-power-fails",
  },
  {
    question: "How do I run G-code?",
    steps: [
      "Open the .nc file as any other.",
      "Read the notes: what Kerf does not know is told before the start.",
    ],
    place: "gcode",
  },
  {
    question: "How do I find a mistake in a part file?",
    steps: [
      "Press the words beside the name of the file: the line opens in the editor.",
      "Go line by line, and watch variables.",
    ],
    place: "console#the-editor",
  },
  {
    question: "How do I use a tablet or phone?",
    steps: [
      "Start Kerf with --lan.",
      "Go to Settings, Devices, and show a code.",
      "Open the address on the phone and type the code.",
    ],
    place: "serve#other-devices",
  },
  {
    question: "How do I see how long a job takes?",
    steps: ["Open it: planned time stands below the picture.", "Timing shows what switches when."],
    place: "time",
  },
];
