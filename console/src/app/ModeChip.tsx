import { attempt } from "../actions/action";
import { moveMode, preview } from "../actions/machine";
import type { Mode } from "../wire/messages";
import { useHands, useShown, worldOf } from "./context";
import "./mode-chip.css";

const words: Record<Mode, string> = { preview: "PREVIEW", simulated: "SIMULATED", cut: "CUT" };

const meaning: Record<Mode, string> = {
  preview: "Files are only drawn; nothing moves.",
  simulated: "The machine is simulated; nothing real moves.",
  cut: "A real machine moves.",
};

/** What running a file means: told by word, colour and pattern. A press changes between preview and cut. */
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
      title={`${meaning[mode]} It is ${name}. A press changes to: ${other.title}.`}
      onClick={() => attempt(other, worldOf(hands))}
    >
      <span className="mode-pattern" aria-hidden="true" />
      <span>{words[mode]}</span>
    </button>
  );
}
