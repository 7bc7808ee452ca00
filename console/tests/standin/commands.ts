/** A few commands as the server tells them. */

import { entry, parameter } from "../../src/command/fixtures";
import type { CommandEntry } from "../../src/wire/messages";

const words = (...list: string[]) => ({ kind: { is: "choice" as const, words: list } });

export const commands: CommandEntry[] = [
  { ...entry("MX", [parameter("X", { doc: "Where to, or how far." })]), name: "Move X" },
  { ...entry("M2", [parameter("X"), parameter("Y")]), name: "Move X Y" },
  { ...entry("MH", []), name: "Move home" },
  {
    ...entry(
      "CC",
      [
        parameter("Diameter", { required: true, least: 0, doc: "Of the circle." }),
        parameter("OIT", { ...words("O", "I", "T"), default: "T", doc: "Outside, inside, on it." }),
        parameter("Direction", { ...words("1", "-1"), default: "1" }),
        parameter("Begin angle", { unit: "deg", default: "0" }),
        parameter("End angle", { unit: "deg", default: "0" }),
        parameter("Plunge", { default: "-0.00" }),
        parameter("Repetitions", { kind: { is: "whole" }, unit: "", default: "1" }),
        parameter("Proportion X", { unit: "", default: "1.00" }),
        parameter("Proportion Y", { unit: "", default: "1.00" }),
        parameter("Feature", { ...words("0", "1", "2", "3", "4"), default: "0" }),
        parameter("No pull-up", { ...words("0", "1"), default: "0" }),
        parameter("From zero", { ...words("0", "1"), default: "0" }),
      ],
      "cut",
    ),
    name: "Circle, by its centre",
    doc: "Cuts a circle or an arc, beginning at the place where the tool is.",
  },
];
