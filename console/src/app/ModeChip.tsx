import { attempt } from "../actions/action";
import { moveMode, preview } from "../actions/machine";
import type { Mode } from "../wire/messages";
import { t } from "../words/words";
import { useHands, useShown, worldOf } from "./context";
import "./mode-chip.css";

const words: Record<Mode, string> = {
  preview: t("PREVIEW"),
  simulated: t("SIMULATED"),
  cut: t("CUT"),
};

const meaning: Record<Mode, string> = {
  preview: t("Files are only drawn; nothing moves."),
  simulated: t("The machine is simulated; nothing real moves."),
  cut: t("A real machine moves."),
};

/** Shows by word, colour and pattern if a file that is run is previewed or cut. A press changes between the two. */
export function ModeChip() {
  const hands = useHands();
  const machine = useShown((shown) => shown.snapshot?.machine);
  if (!machine) return null;
  const { mode, name } = machine;
  const other = mode === "preview" ? moveMode : preview;
  return (
    <button
      type="button"
      className={`mode mode-${mode}`}
      title={t("{0} It is {1}. A press changes to: {2}.", meaning[mode], name, other.title)}
      onClick={() => attempt(other, worldOf(hands))}
    >
      <span className="mode-pattern" aria-hidden="true" />
      <span>{words[mode]}</span>
    </button>
  );
}
