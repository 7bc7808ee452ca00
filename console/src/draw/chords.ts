/** Keys that do to the selection what they do everywhere: copy, cut, paste, nudge, delete. */

import { isMetric, type LengthUnit, type Mm, ofUnit, shown } from "../units/quantity";
import { t } from "../words/words";
import type { Around, DeskState, Done } from "./desk";
import { xy } from "./tools/tool";

type Chord = (state: DeskState, around: Around) => Done | null;

interface Modifiers {
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
  readonly shiftKey: boolean;
}

/** Does something to what is selected while no tool is at work. */
const onSelection =
  (clauses: string, words?: (count: number) => string): Chord =>
  (state, { selected }) => {
    if (state.running || selected.length === 0) return null;
    return { state, clauses, ...(words ? { words: words(selected.length) } : {}) };
  };

const counted = (count: number): string =>
  count === 1 ? t("1 shape is") : t("{0} shapes are", count);
const copied = (count: number): string => t("{0} on the clipboard.", counted(count));

/** Pastes with the lower left at the mouse, or in the middle of what is in sight. */
const paste: Chord = (state) =>
  state.running ? null : { state, clauses: `paste ${xy(state.pointer ?? state.window.middle)}` };

const withCtrl: Readonly<Record<string, Chord>> = {
  c: onSelection("clip", copied),
  x: onSelection("clip; erase", copied),
  v: paste,
};

const arrows: Readonly<Record<string, readonly [number, number]>> = {
  arrowleft: [-1, 0],
  arrowright: [1, 0],
  arrowup: [0, 1],
  arrowdown: [0, -1],
};

/** The step of an arrow key, in the unit of the page: a millimetre, or a sixteenth of an inch. */
const stepIn = (unit: LengthUnit): Mm => ofUnit(shown(isMetric(unit) ? 1 : 1 / 16), unit);

/** The chord of a press; nothing where it is none. Shift nudges ten times as far, Alt a tenth. */
export function chordOf(key: string, press: Modifiers, unit: LengthUnit): Chord | undefined {
  if (press.ctrlKey || press.metaKey)
    return press.shiftKey || press.altKey ? undefined : withCtrl[key];
  const way = arrows[key];
  if (way) {
    const step = stepIn(unit) * (press.shiftKey ? 10 : press.altKey ? 0.1 : 1);
    const to = { x: way[0] * step, y: way[1] * step };
    return onSelection(`move from 0,0 to ${xy(to)}`);
  }
  return key === "backspace" ? onSelection("erase") : undefined;
}
