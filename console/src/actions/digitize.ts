/** Digitizing is begun from any screen; its keys and points stand on the operator's. */

import { begin, press } from "../digitize/keys";
import { t } from "../words/words";
import type { Action } from "./action";

/** Begins to record points with the tool, as the hand console's function does. */
export const digitize: Action = {
  id: "machine.digitize",
  title: t("Digitize: record points with the tool"),
  section: "machine",
  refused: ({ shown }) =>
    shown.snapshot?.drawingOnly ? t("Only drawings are worked on here.") : undefined,
  run: (world) => {
    world.screen.go("/");
    void press(world, begin);
  },
};
