/** A snapshot as the server sends it, for tests that need no server. */

import { message, type Unmarked } from "../../src/units/testing";
import type { AxisUnits, FileParameters, Lamp, Snapshot } from "../../src/wire/messages";

/** Parameters with which a file is run when nobody says otherwise. */
export const usualParameters = message<FileParameters>({
  proportion: [1, 1, 1],
  repetitions: 1,
  offset: 0,
  plunge: 0,
  tabs: false,
  plungeFromZero: false,
});

const axis = (letter: string, used: boolean, unit = "in", scale = 25.4): Unmarked<AxisUnits> => ({
  letter,
  unit,
  scale,
  used,
});

const lamps = (on: number[]): Lamp[] =>
  Array.from({ length: 12 }, (_, n) => ({
    number: n + 1,
    on: on.includes(n + 1),
    label: "",
    duty: "standard",
  }));

type Six = [number, number, number, number, number, number];
const place = (x: number, y: number, z: number): Six => [x * 25.4, y * 25.4, z * 25.4, 0, 0, 0];

export const firstSnapshot = message<Snapshot>({
  version: 1,
  kerf: "0.1.0",
  stopPort: 0,
  drawingOnly: false,
  machine: {
    state: "idle",
    mode: "simulated",
    armed: false,
    why: null,
    wantsTool: false,
    touchesOff: false,
    name: "Simulated machine",
    offers: { inputs: true, card: true, startArms: true },
    pace: null,
  },
  motion: {
    at: { working: place(0, 0, 0.5), base: place(12, 8, 3.5), machine: place(0, 0, 0.5) },
    speedMmS: 0,
    t: 0,
    cutting: false,
    line: 0,
    made: 0,
    progress: 0,
    remaining: 0,
    elapsed: 0,
  },
  units: {
    linear: "in",
    mm: 25.4,
    absolute: true,
    axes: [
      axis("X", true),
      axis("Y", true),
      axis("Z", true),
      axis("A", false),
      axis("B", false, "deg", 1),
      axis("C", false, "deg", 1),
    ],
  },
  setup: {
    heights: { top: -10, surface: -20, bottom: -30 },
    reach: [2500, 1250],
    protected: false,
    outputsStayOn: false,
    pickRadius: 8,
    windowExpansion: 5,
    homed: "XYZ",
    notHomed: "",
  },
  speeds: {
    cutMmS: [38.1, 12.7, 25.4, 25.4, 25.4],
    jogMmS: [152.4, 50.8, 50.8, 50.8, 50.8],
    rpm: 0,
  },
  io: {
    inputs: lamps([4]),
    outputs: lamps([]),
    ports: { inputs: [0, 0], outputs: [0, 0, 0] },
    forbidden: null,
  },
  opened: {
    name: "first-cut.sbp",
    hash: "abc",
    content: "abc",
    kind: "program",
    choice: { start: null, offset: 0, origin: null, finish: null, lift: 0 },
    origin: null,
    added: 0,
    parameters: usualParameters,
    lines: 24,
    header: "First cut: the outline of a rectangle, 4 by 2 inches, an eighth of an inch deep.",
    preview: { state: "ready", key: "first" },
    seconds: 31.4,
    samples: [],
    findings: [],
    broken: false,
    ran: null,
    cleared: false,
  },
  job: null,
  typed: { key: 0, segments: 0 },
  together: [],
  interrupted: null,
  pause: null,
  sound: null,
  start: null,
  asked: null,
  overrides: { feedPercent: 100, rapidPercent: null, spindlePercent: null },
  zeros: [],
  controllerSettings: [],
  controllerSteps: [],
  controllerCard: {
    has: false,
    why: "",
    files: null,
    task: null,
    refused: [],
    replaces: null,
    unread: null,
    kept: null,
    notes: [],
  },
  tools: { tools: [], inSpindle: 0, hasSensor: false, findsHome: true },
  heightMap: null,
  wiring: null,
  printed: [],
  messages: [
    {
      tone: "note",
      code: "",
      text: "Kerf is ready: the machine is simulated.",
      hint: "",
      run: 0,
      place: null,
    },
  ],
  lease: null,
  clients: [],
  drawing: null,
  files: 1,
  folder: { name: "", mask: "*.sb?" },
  recorder: { on: true, lines: [] },
  watched: [],
  settings: 0,
  handConsole: { lines: ["JOB: Untitled", "0x0mm #0"], beeps: 0, link: "" },
  digitized: null,
  looked: null,
  revision: 0,
});
