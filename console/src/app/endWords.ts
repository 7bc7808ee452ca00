/** Words for the ends of runs. */

import { t } from "../words/words";

const words: Readonly<Record<string, string>> = {
  ok: t("finished"),
  ended: t("ended by itself"),
  limit: t("ended at a limit"),
  failed: t("failed"),
  stopped: t("stopped"),
  "cut short": t("cut short"),
};

/** Words for the end of a run. */
export const endWord = (ended: string): string => words[ended] ?? ended;
