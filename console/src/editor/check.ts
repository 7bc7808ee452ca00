/** The state of the check of the text in the editor. */

import { Refused } from "../link/http";
import type { Checked, Finding } from "../wire/messages";
import { t } from "../words/words";

export type Check =
  | { readonly is: "checking" }
  | { readonly is: "unchecked"; readonly why: string }
  | { readonly is: "checked"; readonly findings: readonly Finding[] };

export const checking: Check = { is: "checking" };

/** The answer to a text that is larger than is checked while somebody types. */
const tooLarge = 413;

const largeWords = t("the text is larger than is checked while you type; a saved file is checked");

/** What became of a check that did not come to its end. */
export const unchecked = (error: unknown): Check => ({
  is: "unchecked",
  why:
    error instanceof Refused && error.status === tooLarge
      ? largeWords
      : error instanceof Error
        ? error.message
        : String(error),
});

/** Asks for checks of a text; one that was too large is not sent again at that length or longer. */
export function checker(ask: (text: string) => Promise<Checked>) {
  let least = Number.POSITIVE_INFINITY;
  return async (length: number, text: () => string): Promise<Check> => {
    if (length >= least) return { is: "unchecked", why: largeWords };
    try {
      const { findings } = await ask(text());
      return { is: "checked", findings };
    } catch (error) {
      if (error instanceof Refused && error.status === tooLarge) least = length;
      return unchecked(error);
    }
  };
}
