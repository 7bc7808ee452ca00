import type { Mode } from "../wire/messages";
import { useShown } from "./context";
import "./mode-chip.css";

const words: Record<Mode, string> = { preview: "PREVIEW", simulated: "SIMULATED", cut: "CUT" };

const meaning: Record<Mode, string> = {
  preview: "Files are only drawn; nothing moves.",
  simulated: "The machine is simulated; nothing real moves.",
  cut: "A real machine moves.",
};

/** What running a file means: told by word, colour and pattern. */
export function ModeChip() {
  const mode = useShown((shown) => shown.snapshot?.machine.mode);
  if (!mode) return null;
  return (
    <span className={`mode mode-${mode}`} title={meaning[mode]}>
      <span className="mode-pattern" aria-hidden="true" />
      <span>{words[mode]}</span>
    </span>
  );
}
