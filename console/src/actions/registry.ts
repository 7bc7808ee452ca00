/** The one list of actions. A screen of its own (the drawing) adds its actions here. */

import type { Action } from "./action";
import { digitize } from "./digitize";
import { drawActions } from "./draw";
import { frameJob } from "./frame";
import { goActions } from "./go";
import { jobActions } from "./job";
import { machineActions } from "./machine";

export const actions: readonly Action[] = [
  ...machineActions,
  ...jobActions,
  frameJob,
  digitize,
  ...goActions,
  ...drawActions,
];
