/** Words of the line below the drawing. */

import { t } from "../words/words";
import type { DeskState } from "./desk";
import { keysAt, snapNames } from "./snap";
import { asked, baseOf, type Running } from "./tools/running";
import { wrapped } from "./tools/turn";

export interface Prompt {
  readonly title: string;
  readonly words: string;
  /** Snap keys that mean something now. */
  readonly keys: string;
  readonly snap: string | null;
}

const idle: Prompt = {
  title: t("Select"),
  words: t(
    "Click a shape or drag a region; Shift adds. The right button does the last tool again.",
  ),
  keys: "",
  snap: null,
};

export function promptOf({ running, turnStep }: DeskState): Prompt {
  if (!running) return idle;
  const ask = asked(running);
  const picks = ask?.ask !== "shapes" && ask?.ask !== "region" && ask?.ask !== "vertices";
  return {
    title: running.tool.title,
    words: [wordsOf(running), turning(running, turnStep)].filter(Boolean).join(" · "),
    keys: picks ? keysAt(baseOf(running)) : "",
    snap: running.snap && snapNames[running.snap],
  };
}

function wordsOf(running: Running): string {
  const ask = asked(running);
  if (!ask) return "";
  if (running.bending) return t("Bulge: move the mouse, or T to type it");
  switch (ask.ask) {
    case "shapes":
      return t(
        "{0} ({1} picked), then Enter or the right button",
        ask.prompt,
        running.picked.length,
      );
    case "vertices":
      return t(
        "{0} ({1} picked), then Enter or the right button",
        ask.prompt,
        running.marks.length,
      );
    case "path":
      return running.vertices.length > 0 ? t("{0}; Enter ends", ask.prompt) : t("First place");
    case "number":
      return ask.from ? t("{0}: with the mouse, or T to type it", ask.prompt) : ask.prompt;
    default:
      return ask.prompt;
  }
}

const turning = ({ tool, turned }: Running, step: number): string =>
  tool.turns ? t("turned {0}° by ← →, step {1}° by ↑ ↓", wrapped(turned), step) : "";
