/** Gives a typed entry to the tool at work. */

import type { LengthUnit } from "../units/quantity";
import type { Around, DeskState, Done } from "./desk";
import { taken } from "./desk";
import { isWrong, type Read, readLength, readNumber, readPlace } from "./entry";
import { asked, baseOf, giveBulge, giveNumber, givePlace, type Running } from "./tools/running";

/** Takes what was typed. What is wrong with it stays in sight; the entry stays open. */
export function entered(state: DeskState, text: string, unit: LengthUnit, around: Around): Done {
  const { running } = state;
  if (!running) return { state: { ...state, entry: null } };
  const ask = asked(running);
  if (running.bending)
    return use(state, readNumber(text), around, (bulge) => giveBulge(running, bulge));
  if (ask?.ask === "number") return number(state, running, text, unit, around);
  const read = readPlace(text, unit, baseOf(running));
  return use(state, read, around, (at) => givePlace(running, at, around.picking.shapes));
}

function number(
  state: DeskState,
  running: Running,
  text: string,
  unit: LengthUnit,
  around: Around,
): Done {
  const ask = asked(running);
  if (ask?.ask !== "number") return { state };
  const read = ask.kind === "length" ? readLength(text, unit) : readNumber(text);
  const refused = isWrong(read) ? undefined : ask.accepts?.(read.value);
  if (refused) return { state, words: `${ask.prompt} ${refused}.` };
  return use(state, read, around, (value) => giveNumber(running, value));
}

function use<T>(
  state: DeskState,
  read: Read<T>,
  around: Around,
  give: (value: T) => Parameters<typeof taken>[1],
): Done {
  return isWrong(read) ? { state, words: read.wrong } : taken(state, give(read.value), around);
}
