/** Sentences of findings in German, by their codes. */

import type { FindingText } from "./finding";
import { gcodeFindings } from "./gcode";
import { machineFindings } from "./machine";
import { readingFindings } from "./reading";
import { runningFindings } from "./running";

export const findingTexts: Readonly<Record<string, FindingText>> = {
  ...readingFindings,
  ...runningFindings,
  ...gcodeFindings,
  ...machineFindings,
};
