/** Single keys of the desk as data: the keys, their menus and the buttons in sight are made of this list. */

import { t } from "../words/words";
import {
  type Around,
  type DeskState,
  type Done,
  escaped,
  rightClicked,
  takesPlace,
  takesShape,
} from "./desk";
import { isSnapKey, keysAt, type SnapKey, snapNames } from "./snap";
import { asked, baseOf } from "./tools/running";
import { larger, smaller, turnedOn } from "./tools/turn";
import { centredOn, fitted, type Window, zoomedTo } from "./window";

/** Menu in which a key's button stands. */
export type KeyMenu = "window" | "snap" | "turn" | "tool";

export interface DeskKey {
  /** As `KeyboardEvent.key`, in small letters. */
  readonly key: string;
  /** Text on its button; for the window, the name of a picture. */
  readonly sign: string;
  readonly title: string;
  readonly menu: KeyMenu;
  /** Nothing when it means nothing now. */
  readonly press: (state: DeskState, around: Around) => Done | null;
}

/** Z, X, S and A change the window in the middle of anything. */
const windowKey = (
  key: string,
  sign: string,
  title: string,
  to: (state: DeskState, around: Around) => Window,
): DeskKey => ({
  key,
  sign,
  title,
  menu: "window",
  press: (state, around) => ({ state: { ...state, window: to(state, around) } }),
});

const pointerOf = ({ pointer, window }: DeskState) => pointer ?? window.middle;

const windowKeys: readonly DeskKey[] = [
  windowKey("z", "in", t("Zoom in"), (s) => zoomedTo(s.window, pointerOf(s), 2)),
  windowKey("x", "out", t("Zoom out"), (s) => zoomedTo(s.window, pointerOf(s), 0.5)),
  windowKey("s", "centre", t("Centre on the mouse"), (s) => centredOn(s.window, pointerOf(s))),
  windowKey("a", "all", t("Show all"), (s, { box, expansion }) => fitted(box, s.size, expansion)),
];

/** Arms a snap for the next pick, or none. */
const snapKey = (key: SnapKey | "q", title: string): DeskKey => ({
  key,
  sign: key.toUpperCase(),
  title,
  menu: "snap",
  press: (state) => {
    const { running } = state;
    if (!running || !(takesPlace(running) || takesShape(running))) return null;
    if (!keysAt(baseOf(running)).toLowerCase().includes(key)) return null;
    return { state: { ...state, running: { ...running, snap: isSnapKey(key) ? key : null } } };
  },
});

const snapKeys: readonly DeskKey[] = [
  ...(Object.keys(snapNames) as SnapKey[]).map((key) =>
    snapKey(key, t("Snap: {0}", snapNames[key])),
  ),
  snapKey("q", t("No snap")),
];

const turns = (key: string, sign: string, title: string, way: 1 | -1): DeskKey => ({
  key,
  sign,
  title,
  menu: "turn",
  press: (state) => {
    const { running, turnStep } = state;
    if (!running?.tool.turns) return null;
    const turned = turnedOn(running.turned, turnStep, way);
    return { state: { ...state, running: { ...running, turned } } };
  },
});

const steps = (
  key: string,
  sign: string,
  title: string,
  to: (step: number) => number,
): DeskKey => ({
  key,
  sign,
  title,
  menu: "turn",
  press: (state) =>
    state.running?.tool.turns ? { state: { ...state, turnStep: to(state.turnStep) } } : null,
});

const turnKeys: readonly DeskKey[] = [
  turns("arrowleft", "↺", t("Turn counter-clockwise"), 1),
  turns("arrowright", "↻", t("Turn clockwise"), -1),
  steps("arrowup", "⇑", t("Larger steps of turning"), larger),
  steps("arrowdown", "⇓", t("Smaller steps of turning"), smaller),
];

/** Gives up what is there to be given up. */
const given = (state: DeskState, around: Around): Done | null =>
  state.running || state.chooser || state.drag || around.selected.length > 0
    ? escaped(state, around)
    : null;

const toolKeys: readonly DeskKey[] = [
  {
    key: "t",
    sign: t("Type"),
    title: t("Type a place or a number"),
    menu: "tool",
    press: (state) => (takesEntry(state) ? { state: { ...state, entry: "" } } : null),
  },
  {
    key: "enter",
    sign: t("Done"),
    title: t("Finish, or the last tool again (right button)"),
    menu: "tool",
    press: (state, around) => (state.running || state.last ? rightClicked(state, around) : null),
  },
  { key: "escape", sign: t("Cancel"), title: t("Give the tool up"), menu: "tool", press: given },
  {
    key: "delete",
    sign: t("Delete"),
    title: t("Erase what is selected"),
    menu: "tool",
    press: (state, { selected }) =>
      state.running || selected.length === 0 ? null : { state, clauses: "erase" },
  },
];

export const deskKeys: readonly DeskKey[] = [...windowKeys, ...snapKeys, ...turnKeys, ...toolKeys];

export const keysIn = (menu: KeyMenu): readonly DeskKey[] =>
  deskKeys.filter((key) => key.menu === menu);

const takesEntry = ({ running }: DeskState): boolean =>
  running !== null &&
  (takesPlace(running) || running.bending !== null || asked(running)?.ask === "number");

const beginsNumber = (key: string): boolean => /^[\d@.-]$/.test(key);

/** The beginning of a number opens the entry with it. */
const begun = (state: DeskState, key: string): Done | null =>
  takesEntry(state) && beginsNumber(key) ? { state: { ...state, entry: key } } : null;

/** Tells whether a key without modifiers may mean something here, at one time or another. */
export const isDeskKey = (key: string): boolean =>
  beginsNumber(key) || deskKeys.some((other) => other.key === key);

/** A key without modifiers; nothing when it means nothing here. */
export function typed(state: DeskState, key: string, around: Around): Done | null {
  const known = deskKeys.find((other) => other.key === key);
  return known?.press(state, around) ?? begun(state, key);
}
