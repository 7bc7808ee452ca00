/** States of the machine in which screens are looked at. */

import { mmPerS, seconds } from "../../src/units/quantity";
import { message } from "../../src/units/testing";
import type { Positions, Snapshot } from "../../src/wire/messages";
import { drawing } from "./drawing";
import { firstSnapshot } from "./snapshot";

const { machine, motion } = firstSnapshot;
const running: Partial<Snapshot> = {
  machine: { ...machine, state: "running", armed: true },
  motion: {
    ...motion,
    at: message<Positions>({
      working: [101.6, 76.2, -3.175, 0, 0, 0],
      base: [406.4, 279.4, 73.025, 0, 0, 0],
      machine: [101.6, 76.2, -3.175, 0, 0, 0],
    }),
    speedMmS: mmPerS(38.1),
    line: 13,
    made: 4,
    progress: 0.46,
    remaining: seconds(17),
    elapsed: seconds(14),
    cutting: true,
  },
  job: {
    run: 1,
    file: "first-cut.sbp",
    hash: "abc",
    command: null,
    fromCard: false,
    seconds: seconds(31.4),
    calls: [{ file: "first-cut.sbp", line: 14 }],
    drawsOnly: false,
    silent: false,
    toolFile: "first-cut.sbp",
    heights: null,
    inForce: null,
    ended: null,
    error: null,
  },
  lease: { number: 1, client: 1, device: "" },
};

export const states: Record<string, Partial<Snapshot>> = {
  ready: { machine: { ...machine, armed: true }, lease: { number: 1, client: 1, device: "" } },
  running,
  drawing: { drawing },
  held: { ...running, machine: { ...machine, state: "held", armed: true } },
  asking: {
    ...running,
    machine: { ...machine, state: "asking", armed: true },
    asked: {
      number: 3,
      kind: "msgbox",
      text: "Is the second clamp out of the way?\nThe next cut passes within 2 inches.",
      title: "Clamps",
      buttons: ["Yes", "No", "Cancel"],
      default: 0,
      prefill: "",
      entry: false,
      icon: 48,
      edits: null,
      file: "first-cut.sbp",
      line: 9,
      was: "running",
    },
  },
};
