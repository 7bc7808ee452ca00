/** Every sentence of the server that a page shows, in German. */

import { colours } from "../operations";
import { boardsSentences } from "./boards";
import { cardSentences } from "./card";
import { configurationSentences } from "./configuration";
import { controllerLineSentences } from "./controllerLines";
import { controllerNames } from "./controllerNames";
import { controllersSentences } from "./controllers";
import { drawingSentences } from "./drawing";
import { filesSentences } from "./files";
import { findingSentences } from "./findings";
import { importingSentences } from "./importing";
import { jobsSentences } from "./jobs";
import { journalSentences } from "./journal";
import { operatingSentences } from "./operating";
import { runningSentences } from "./running";
import { servingSentences } from "./serving";
import { settingsExplained } from "./settingsExplained";
import { warmUpSentences } from "./warmUp";

export const sentences: Readonly<Record<string, string>> = {
  ...colours,
  ...operatingSentences,
  ...findingSentences,
  ...filesSentences,
  ...servingSentences,
  ...runningSentences,
  ...controllerNames,
  ...settingsExplained,
  ...controllersSentences,
  ...cardSentences,
  ...controllerLineSentences,
  ...warmUpSentences,
  ...boardsSentences,
  ...configurationSentences,
  ...journalSentences,
  ...importingSentences,
  ...jobsSentences,
  ...drawingSentences,
};
