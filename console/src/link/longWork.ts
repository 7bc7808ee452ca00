/** Acts that may take longer than a moment, and that the page can give up. */

import type { Act } from "../wire/messages";
import { t } from "../words/words";

/** The words for what is waited for; nothing for an act that is done at once. */
export function longWork(act: Act): string | null {
  switch (act.do) {
    case "machine":
      return t("The tool path is being made.");
    case "draw":
      return act.op.op === "open" ? t("The drawing {0} is being read.", act.op.name) : null;
    default:
      return null;
  }
}
