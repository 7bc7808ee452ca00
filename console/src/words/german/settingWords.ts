/** Words that a setting may be, in German; letters of axes, units and names of devices stay as they are. */

export const settingWords: Readonly<Record<string, string>> = {
  absolute: "Orte",
  relative: "Abstände",
  ask: "fragen",
  tell: "melden",
  refuse: "ablehnen",
  both: "beide",
  continue: "weiter",
  pause: "Pause",
  high: "hoch",
  low: "niedrig",
  input: "Eingang",
  minus: "am kleinen Ende",
  plus: "am großen Ende",
  none: "kein",
  optimal: "optimal",
  simple: "einfach",
  proportional: "proportional",
  time: "Zeit",
};

/** Names that are the same in every language. */
export const deviceWords = ["io", "pci", "pwm", "profiler", "shopbot"];
