/** Steps of the wizard that wires a board: the words of each question and the answers that have a button. */

import { t } from "../words/words";

/** An answer with a button: what is sent, and what stands on it. */
export interface Choice {
  readonly answer: string;
  readonly words: string;
}

export interface Step {
  /** The question. */
  readonly ask: (about: string, value: string) => string;
  /** Answers with a button, the usual one first. */
  readonly choices: readonly Choice[];
  /** The name of the entry, where one is written. */
  readonly entry?: string;
  readonly hint?: string;
}

const yesNo = (yes: string, no: string): Choice[] => [
  { answer: "y", words: yes },
  { answer: "n", words: no },
];
const goes: Choice[] = [{ answer: "", words: "Turn it" }];
const looked: Choice[] = [{ answer: "", words: "Done" }];
const cameBack = yesNo(t("It came back to its place"), t("It did not"));
const tries = [
  { answer: "n", words: "Leave it as it is" },
  { answer: "y", words: "Try" },
];

const pins = t(
  "As the board names them: gpio0 or PA3. ! turns a level round, ^ pulls an input up.",
);
const unit = (about: string) => (about === "A" ? "°" : "mm");

/** An entry of pins. */
const entry = (ask: Step["ask"], hint = pins): Step => ({
  ask,
  choices: [],
  entry: t("Pins"),
  hint,
});

export const steps: Record<string, Step> = {
  motor: entry((axis) => t("Motor {0}: its pins of step and direction", axis)),
  secondMotor: entry((axis) => t("Second motor of {0}: its pins of step and direction", axis)),
  home: entry((axis) => t("Home switch of {0}: its pin; - for none", axis)),
  secondHome: entry((axis) =>
    t("Home switch of the second motor of {0}: its pin; - for none of its own", axis),
  ),
  enable: entry(() => t("Pins that give the motors their current; - for none")),
  outputs: entry(() => t("Outputs by number, with their pins: 1 gpio20, 2 gpio21")),
  inputs: entry(() => t("Inputs by number, with their pins: 1 ^gpio22; - for none")),
  torch: {
    ask: () => t("Is there a torch whose height is controlled?"),
    choices: [
      { answer: "n", words: "No" },
      { answer: "y", words: "Yes" },
    ],
  },
  torchVoltage: entry(() => t("Pin that measures the voltage of its arc, divided; - for none")),
  torchSwitches: entry(() =>
    t("Pins of the two switches of its head, too high and too low; - for none"),
  ),
  current: {
    ask: (motor) => t("Current of motor {0} while it turns, amperes", motor),
    choices: [],
    entry: t("Amperes"),
    hint: t("What is printed on the motor, or less."),
  },
  further: {
    ask: () => t("Has an axis two motors, or is there a rotary axis?"),
    choices: [
      { answer: "n", words: "No" },
      { answer: "y", words: "Yes" },
    ],
  },
  goes: {
    ask: (axis) => t("{0} goes 1 {1} towards plus, and back. Look at it.", axis, unit(axis)),
    choices: goes,
  },
  went: {
    ask: (axis) => t("Which way did {0} go?", axis),
    choices: [
      { answer: "y", words: "It moved right" },
      { answer: "n", words: "It moved the wrong way" },
      { answer: "0", words: "It did not move" },
    ],
    entry: t("It moved so far"),
    hint: t("Measured, where it was another way: the steps per mm follow."),
  },
  bothGo: {
    ask: (axis) => t("{0} goes 1 mm with both motors. Look at them.", axis),
    choices: goes,
  },
  bothWent: {
    ask: () => t("Did both go the same way?"),
    choices: yesNo(t("The same way"), t("Against each other")),
  },
  leaveSwitch: {
    ask: (axis) => t("{0}: leave its home switch alone.", axis),
    choices: looked,
  },
  pressSwitch: {
    ask: (axis) => t("{0}: press its home switch, and hold it.", axis),
    choices: looked,
  },
  unseen: {
    ask: () => t("Nothing changed: look at its pin and its wires."),
    choices: yesNo(t("Look again"), t("Leave it")),
  },
  outputGoes: {
    ask: (output) => t("Output {0} goes on for a second.", output),
    choices: [
      { answer: "", words: "Switch it on" },
      { answer: "s", words: "Leave it out" },
    ],
  },
  outputWent: { ask: () => t("Did it go on?"), choices: yesNo(t("It did"), t("It did not go on")) },
  trySpeed: {
    ask: (axis) => t("{0}: try its speed, 20 mm there and back, more each time?", axis),
    choices: tries,
  },
  tryAcceleration: {
    ask: (axis) => t("{0}: try its acceleration, 20 mm there and back, more each time?", axis),
    choices: tries,
  },
  speedGood: {
    ask: (axis, value) => t("{0} at {1} {2}/s", axis, value, unit(axis)),
    choices: cameBack,
  },
  accelerationGood: {
    ask: (axis, value) => t("{0} at {1} {2}/s²", axis, value, unit(axis)),
    choices: cameBack,
  },
};
