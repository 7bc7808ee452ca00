/**
 * The command line as values: what is typed, what it means, what comes back with the arrow keys.
 *
 * Two letters name a command and are followed by a comma, which comes by itself.
 */

import type { CommandEntry, Parameter } from "../wire/messages";
import { findCommand } from "./table";

export interface LineState {
  readonly text: string;
  /** Lines that were sent, oldest first. */
  readonly history: readonly string[];
  /** Place in the history; its length while a new line is typed. */
  readonly at: number;
  /** The comma behind the letters came by itself: one that is typed now is the same. */
  readonly parted?: boolean;
}

export const emptyLine: LineState = { text: "", history: [], at: 0 };

const mostHistory = 100;

/** The letters a line begins with, when they could be a command's. */
export const lettersOf = (text: string): string | undefined =>
  /^\s*([A-Za-z][A-Za-z0-9])(?=[\s,]|$)/.exec(text)?.[1]?.toUpperCase();

export function commandOf(table: readonly CommandEntry[], text: string): CommandEntry | undefined {
  const letters = lettersOf(text);
  return letters === undefined ? undefined : findCommand(table, letters);
}

/** Splits a line into its parameters; a comma in quotes does not part them. */
export function argumentsOf(text: string): string[] {
  const rest = text.replace(/^\s*[A-Za-z][A-Za-z0-9]\s*,?/, "");
  if (rest.trim() === "") return [];
  const parts: string[] = [""];
  let quoted = false;
  for (const letter of rest) {
    if (letter === '"') quoted = !quoted;
    if (letter === "," && !quoted) parts.push("");
    else parts[parts.length - 1] += letter;
  }
  return parts.map((part) => part.trim());
}

/** Finds the parameter that is being written by counting the commas before. */
export function parameterAt(entry: CommandEntry, text: string): Parameter | undefined {
  return entry.parameters[Math.max(argumentsOf(text).length - 1, 0)];
}

/** Gives the state of the line after a person typed. */
export function typed(state: LineState, text: string, table: readonly CommandEntry[]): LineState {
  const grows = text.length === state.text.length + 1 && text.startsWith(state.text);
  const named = grows && text.length === 2 ? commandOf(table, text) : undefined;
  if (named && named.parameters.length > 0) {
    return { ...state, text: `${text.toUpperCase()},`, parted: true };
  }
  // The separator that came by itself is not written twice.
  const doubled = grows && state.parted === true && /^[A-Z][A-Z0-9],[\s,]$/.test(text);
  return { ...state, text: doubled ? state.text : text, parted: false };
}

/** Tells whether a command acts without ENTER: it has no parameters. */
export const isImmediate = (entry: CommandEntry | undefined): boolean =>
  entry !== undefined && entry.parameters.length === 0;

export function sent(state: LineState): LineState {
  const history = [...state.history.filter((line) => line !== state.text), state.text];
  const kept = history.slice(-mostHistory);
  return { text: "", history: kept, at: kept.length };
}

/** An arrow key: to an older line, or a newer one. */
export function recalled(state: LineState, by: -1 | 1): LineState {
  const at = Math.min(Math.max(state.at + by, 0), state.history.length);
  return { ...state, at, text: state.history[at] ?? "" };
}
