/** Words about a setting of a controller in the language of the page. */

import type { ControllerSetting } from "../wire/messages";
import { serverWords } from "../words/server";

/** The name of a setting; that of the controller itself stays as it tells it. */
export const named = ({ name }: ControllerSetting): string => serverWords(name);

/** Explains a setting: a sentence, then the controller's own words. Empty where nobody knows. */
export const explained = ({ does, own }: ControllerSetting): string[] =>
  [does && serverWords(does), own].filter(Boolean);
