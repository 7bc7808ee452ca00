/** Asks the server about a text: mistakes, completions, words under the pointer. */

import { postJson } from "../link/http";
import type { Checked, Hover, Completion as Offered } from "../wire/messages";

export interface At {
  readonly name: string;
  readonly text: string;
  /** Line and column, from 1. */
  readonly line: number;
  readonly column: number;
}

export const checkText = (name: string, text: string): Promise<Checked> =>
  postJson("/api/language/check", { name, text });

/** Checks lines of a larger text by themselves. */
export const checkLines = (name: string, text: string): Promise<Checked> =>
  postJson("/api/language/check", { name, text, part: true });

export const completionsAt = (at: At): Promise<Offered[]> => postJson("/api/language/complete", at);

export const hoverAt = (at: At): Promise<Hover | null> => postJson("/api/language/hover", at);
