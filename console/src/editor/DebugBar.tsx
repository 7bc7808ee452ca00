import { singleStep } from "../actions/job";
import { useScreen } from "../app/context";
import { ActionButton } from "../ui/ActionButton";

/** Begins to go through the open file line by line (FG); `changed`: the text is not what would run. */
export function DebugBar({ changed }: { changed: boolean }) {
  const breakpoints = useScreen("breakpoints");
  return (
    <div className="debug" role="toolbar" aria-label="Debugger">
      <ActionButton action={singleStep} size="small">
        Go line by line
      </ActionButton>
      <span className="debug-words">{words(changed, breakpoints)}</span>
    </div>
  );
}

function words(changed: boolean, breakpoints: readonly number[]): string {
  if (changed) return "Save before running: what runs is the file.";
  return breakpoints.length > 0
    ? `Breakpoints: ${breakpoints.join(", ")}`
    : "A click beside a line number, or F9, sets a breakpoint.";
}
