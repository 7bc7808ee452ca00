/**
 * The drawing desk: what hands do to a drawing, as pure steps of one state.
 *
 * Pointers, buttons and keys come in; a new state goes out, and now and then operations for the
 * server or words for the person.
 */

import { t } from "../words/words";
import type { Shape } from "./geometry/shape";
import { type Box, distance, type Place } from "./geometry/vec";
import { type Picking, shapesNear } from "./pick";
import { isCrossing, isWithin, shapesIn } from "./region";
import { snapNames, snapped } from "./snap";
import {
  asked,
  baseOf,
  begin,
  finish,
  giveMark,
  giveMarks,
  givePlace,
  giveRegion,
  giveShape,
  giveShapes,
  markable,
  type Running,
  type Step,
} from "./tools/running";
import { type Mark, select, type Tool, xy } from "./tools/tool";
import { firstStep } from "./tools/turn";
import { fitted, panned, type Size, type Window } from "./window";

/** A press that moves less is a click, pixels. */
const clickSlack = 4;

export type Drag =
  | {
      readonly kind: "shapes";
      readonly numbers: readonly number[];
      readonly from: Place;
      readonly to: Place;
    }
  | { readonly kind: "region"; readonly from: Place; readonly to: Place }
  | { readonly kind: "pan"; readonly at: Place };

export interface Chooser {
  /** Place of the click. */
  readonly at: Place;
  readonly numbers: readonly number[];
}

export interface DeskState {
  readonly window: Window;
  readonly size: Size;
  readonly running: Running | null;
  readonly last: Tool | null;
  readonly turnStep: number;
  /** Place of the mouse, in the drawing. */
  readonly pointer: Place | null;
  readonly drag: Drag | null;
  readonly chooser: Chooser | null;
  /** Text that is being typed at the cursor. */
  readonly entry: string | null;
}

/** Surroundings that a step reads beside the state of the desk. */
export interface Around {
  readonly picking: Picking;
  readonly selected: readonly number[];
  /** Picked to be sequenced, in that order. */
  readonly picked: readonly number[];
  readonly box: Box;
  /** A click picks what lies so near, pixels. */
  readonly pickRadius: number;
  /** The joining distance used last, in the user's unit. */
  readonly lastJoin: number;
  /** So many times larger than what is drawn is the window that shows all of it. */
  readonly expansion: number;
}

export interface Done {
  readonly state: DeskState;
  /** Operations for the server. */
  readonly clauses?: string;
  /** Words for the person. */
  readonly words?: string;
}

export const firstDesk: DeskState = {
  window: { middle: { x: 0, y: 0 }, mmPerPixel: 1 },
  size: { width: 0, height: 0 },
  running: null,
  last: null,
  turnStep: firstStep,
  pointer: null,
  drag: null,
  chooser: null,
  entry: null,
};

const radiusOf = ({ window }: DeskState, { pickRadius }: Around): number =>
  pickRadius * window.mmPerPixel;

/** Takes the outcome of a tool's step into the state. Numbers that only can be typed are asked at once. */
export function taken(state: DeskState, { running, clauses, look }: Step, around: Around): Done {
  const window = look ? fitted(look, state.size, 1) : state.window;
  const next = { ...state, window, running, chooser: null, entry: entryFor(running, around) };
  return clauses === undefined ? { state: next } : { state: next, clauses };
}

function entryFor(running: Running | null, { lastJoin }: Around): string | null {
  const ask = running && asked(running);
  if (ask?.ask !== "number" || ask.from) return null;
  return String(running?.tool.id === "join" ? lastJoin : ask.usual);
}

/** Begins a tool. A button that is down already is a click of it: the tool may have waited for its turn. */
export function startTool(state: DeskState, tool: Tool, around: Around): Done {
  return taken({ ...state, last: tool }, begin(tool, around.selected), around);
}

/** The place that a click here means; nothing when a snap finds nothing. */
export function pickPlace(state: DeskState, at: Place, around: Around): Place | null {
  const { running } = state;
  const base = running && baseOf(running);
  return snapped(running?.snap ?? null, at, around.picking, radiusOf(state, around), base);
}

/** Shapes that a click would pick, in cutting order. */
export const shapesUnder = (state: DeskState, at: Place, around: Around): Shape[] =>
  shapesNear(around.picking, at, radiusOf(state, around));

export const takesShape = (running: Running): boolean => asked(running)?.ask === "shape";

/** Tells whether a click gives a place, whatever lies there. */
export const takesPlace = (running: Running): boolean => {
  const ask = asked(running);
  return (
    ask?.ask === "place" || ask?.ask === "path" || (ask?.ask === "number" && ask.from !== undefined)
  );
};

/** The left button went down: on what is selected it takes hold of all of that; else a region begins. */
export function pressed(state: DeskState, at: Place, around: Around): DeskState {
  const numbers = heldAt(state, at, around);
  const drag: Drag =
    numbers.length > 0
      ? { kind: "shapes", numbers, from: at, to: at }
      : { kind: "region", from: at, to: at };
  return { ...state, drag, chooser: null };
}

/** The shapes that a drag from here carries: the selection, where the pointer is on one of it. */
function heldAt(state: DeskState, at: Place, around: Around): readonly number[] {
  if (state.running) return [];
  const isHeld = shapesUnder(state, at, around).some(({ number }) =>
    around.selected.includes(number),
  );
  return isHeld ? around.selected : [];
}

/** The middle button went down, or the space bar is held. */
export const grabbed = (state: DeskState, pixel: Place): DeskState => ({
  ...state,
  drag: { kind: "pan", at: pixel },
});

export function moved(state: DeskState, at: Place, pixel: Place): DeskState {
  const { drag } = state;
  if (drag?.kind === "pan") {
    const window = panned(state.window, pixel.x - drag.at.x, pixel.y - drag.at.y);
    return { ...state, window, drag: { kind: "pan", at: pixel } };
  }
  return { ...state, pointer: at, drag: drag && { ...drag, to: at } };
}

/** A button went up. */
export const released = (state: DeskState): DeskState => ({ ...state, drag: null });

/** Acts on what was dragged until a button went up: a click or a region. `adds` keeps what is selected. */
export function dragged(state: DeskState, drag: Drag | null, adds: boolean, around: Around): Done {
  if (!drag || drag.kind === "pan") return { state };
  if (!isFar(drag, state.window)) return clicked(state, drag.from, adds, around);
  if (drag.kind === "region") return spanned(state, drag.from, drag.to, adds, around);
  const way = `move from ${xy(drag.from)} to ${xy(drag.to)}`;
  return { state, clauses: `${select(drag.numbers)}; ${way}` };
}

/** Tells a drag from a click. */
export const isFar = (drag: Exclude<Drag, { kind: "pan" }>, { mmPerPixel }: Window): boolean =>
  distance(drag.from, drag.to) / mmPerPixel >= clickSlack;

function clicked(state: DeskState, at: Place, adds: boolean, around: Around): Done {
  const { running } = state;
  if (running && takesPlace(running)) return placed(state, running, at, around);
  if (running && asked(running)?.ask === "region") return { state };
  if (running && asked(running)?.ask === "vertices") return marked(state, running, at, around);
  const near = shapesUnder(state, at, around).map(({ number }) => number);
  const [only] = near;
  if (near.length > 1) return { state: { ...state, chooser: { at, numbers: near } } };
  if (only !== undefined) return chosen(state, only, at, adds, around);
  if (running) return { state, words: t("There is no shape within the selection radius.") };
  return adds || around.selected.length === 0 ? { state } : { state, clauses: "select none" };
}

/** The vertices that a click or a window may pick. */
const vertices = (running: Running, { picking }: Around): Mark[] =>
  markable(running, picking.shapes).flatMap(({ number, vertices }) =>
    vertices.map((at) => ({ number, at })),
  );

function marked(state: DeskState, running: Running, at: Place, around: Around): Done {
  const radius = radiusOf(state, around);
  const near = vertices(running, around).filter((mark) => distance(mark.at, at) <= radius);
  const [mark] = near.sort((a, b) => distance(a.at, at) - distance(b.at, at));
  if (mark) return taken(state, giveMark(running, mark), around);
  return { state, words: t("There is no vertex within the selection radius.") };
}

function placed(state: DeskState, running: Running, at: Place, around: Around): Done {
  const place = pickPlace(state, at, around);
  if (place) return taken(state, givePlace(running, place, around.picking.shapes), around);
  const name = running.snap ? snapNames[running.snap] : t("place");
  return { state, words: t("There is no {0} within the selection radius.", name) };
}

/** One of the buttons among which a click that met several shapes lets choose. */
export interface Choice {
  readonly number: number;
  /** True if it is selected or picked already. */
  readonly highlighted: boolean;
}

export function choices({ chooser, running }: DeskState, { selected }: Around): Choice[] {
  const picked = running ? running.picked : selected;
  return (chooser?.numbers ?? []).map((number) => ({
    number,
    highlighted: picked.includes(number),
  }));
}

/** A shape was clicked, alone or in the chooser. */
export function chosen(
  state: DeskState,
  number: number,
  at: Place,
  adds: boolean,
  around: Around,
): Done {
  const { running } = state;
  if (running) {
    const place = pickPlace(state, at, around) ?? at;
    return taken(state, giveShape(running, number, place), around);
  }
  const without = around.selected.includes(number) ? "remove" : "add";
  const clauses = adds ? `select ${without} ${number}` : `select ${number}`;
  return { state: { ...state, chooser: null }, clauses };
}

function spanned(state: DeskState, from: Place, to: Place, adds: boolean, around: Around): Done {
  const { running } = state;
  if (!running) {
    const how = isCrossing(from, to) ? "crossing" : "window";
    return { state, clauses: `select ${adds ? "add " : ""}${how} ${xy(from)} ${xy(to)}` };
  }
  const ask = asked(running)?.ask;
  if (ask === "region") return taken(state, giveRegion(running, from, to), around);
  if (ask === "vertices") {
    const marks = vertices(running, around).filter(({ at }) => isWithin(at, from, to));
    return taken(state, giveMarks(running, marks), around);
  }
  if (ask !== "shapes") return { state };
  const numbers = shapesIn(around.picking.shapes, from, to).map(({ number }) => number);
  return taken(state, giveShapes(running, numbers), around);
}

/** The right button, or Enter: finishes, cancels, or does the last tool again. */
export function rightClicked(state: DeskState, around: Around): Done {
  if (state.running) return taken(state, finish(state.running), around);
  return state.last ? startTool(state, state.last, around) : { state };
}

/** Escape: the entry, the chooser, the tool, the selection; whichever is there first. */
export function escaped(state: DeskState, around: Around): Done {
  if (state.chooser || state.drag) return { state: { ...state, chooser: null, drag: null } };
  if (state.running) return { state: { ...state, running: null, entry: null } };
  return around.selected.length > 0 ? { state, clauses: "select none" } : { state };
}
