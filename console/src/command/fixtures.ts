/** Entries of a command table, for tests. */

import type { CommandEntry, Parameter } from "../wire/messages";

export const parameter = (name: string, more: Partial<Parameter> = {}): Parameter => ({
  name,
  kind: { is: "number" },
  unit: "in",
  required: false,
  default: null,
  present: null,
  bound: "",
  least: null,
  most: null,
  doc: "",
  ...more,
});

export const entry = (letters: string, parameters: Parameter[], group = "move"): CommandEntry => ({
  letters,
  name: letters,
  group,
  doc: "",
  moves: true,
  parameters,
});
