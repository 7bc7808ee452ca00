/** The texts of the console in German, by their English ones. Numbers and commands stay as they are. */

import { actions } from "./actions";
import { controllerCard } from "./controllerCard";
import { controllerLines } from "./controllerLines";
import { controllerSettings } from "./controllerSettings";
import { digitizing } from "./digitizing";
import { drawing } from "./drawing";
import { files } from "./files";
import { help } from "./help";
import { operating } from "./operating";
import { settings } from "./settings";
import { shared } from "./shared";
import { tools } from "./tools";
import { toolTable } from "./toolTable";
import { warmUp } from "./warmUp";
import { wiring } from "./wiring";

export const german: Readonly<Record<string, string>> = {
  ...actions,
  ...digitizing,
  ...drawing,
  ...files,
  ...help,
  ...operating,
  ...settings,
  ...shared,
  ...tools,
  ...controllerLines,
  ...controllerCard,
  ...controllerSettings,
  ...toolTable,
  ...warmUp,
  ...wiring,
};
