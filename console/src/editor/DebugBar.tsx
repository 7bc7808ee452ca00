import { ask } from "../actions/ask";
import { singleStep } from "../actions/job";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";

interface DebugBarProps {
  /** Lines with a breakpoint. */
  breakpoints: readonly number[];
  /** The text is not what would run. */
  changed: boolean;
}

/** Runs the open file line by line (FG). */
export function DebugBar({ breakpoints, changed }: DebugBarProps) {
  const hands = useHands();
  const asked = useSnapshot("asked");
  const steps = asked?.kind === "step" ? asked : undefined;
  return (
    <div className="debug" role="toolbar" aria-label="Debugger">
      <ActionButton action={singleStep} size="small">
        Go line by line
      </ActionButton>
      {steps?.buttons.map((word) => (
        <Button
          key={word}
          size="small"
          onPress={() =>
            void ask(worldOf(hands), { do: "answer", question: steps.number, answer: word })
          }
        >
          {word}
        </Button>
      ))}
      <span className="debug-words">
        {changed
          ? "Save before running: what runs is the file."
          : breakpoints.length > 0
            ? `Breakpoints: ${breakpoints.join(", ")}`
            : "A click beside a line number, or F9, sets a breakpoint."}
      </span>
    </div>
  );
}
