/** Acts that may take longer than a moment, and that the page can give up. */

import type { Act } from "../wire/messages";

/** The words for what is waited for; nothing for an act that is done at once. */
export function longWork(act: Act): string | null {
  switch (act.do) {
    case "machine":
      return "The tool path is being made.";
    case "draw":
      return act.op.op === "open" ? `The drawing ${act.op.name} is being read.` : null;
    default:
      return null;
  }
}
