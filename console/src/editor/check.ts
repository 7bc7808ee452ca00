/** The state of the check of the text in the editor. */

import type { Checked, Finding } from "../wire/messages";

export type Check =
  | { readonly is: "checking" }
  | { readonly is: "unchecked"; readonly why: string }
  /** So much of a long text was looked at, line by line; from 0 to 1. */
  | { readonly is: "lines"; readonly share: number; readonly findings: readonly Finding[] }
  | { readonly is: "checked"; readonly findings: readonly Finding[] };

export const checking: Check = { is: "checking" };

/** Result of a check that did not come to its end. */
export const unchecked = (error: unknown): Check => ({
  is: "unchecked",
  why: error instanceof Error ? error.message : String(error),
});

/** Asks for the check of a text. */
export async function checked(ask: () => Promise<Checked>): Promise<Check> {
  try {
    const { findings } = await ask();
    return { is: "checked", findings };
  } catch (error) {
    return unchecked(error);
  }
}
