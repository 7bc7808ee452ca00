import { singleStep } from "../actions/job";
import { useScreen } from "../app/context";
import type { Breakpoint } from "../app/screen";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";

/** Begins to go through the open file line by line (FG); `changed`: the text is not what would run. */
export function DebugBar({ changed, file }: { changed: boolean; file: string }) {
  const breakpoints = useScreen("breakpoints");
  return (
    <div className="debug" role="toolbar" aria-label={t("Debugger")}>
      <ActionButton action={singleStep} size="small">
        Go line by line
      </ActionButton>
      <span className="debug-words">{words(changed, breakpoints, file)}</span>
    </div>
  );
}

function words(changed: boolean, breakpoints: readonly Breakpoint[], file: string): string {
  if (changed) return t("Save before running: what runs is the file.");
  return breakpoints.length > 0
    ? t("Breakpoints: {0}", breakpoints.map((one) => lineText(one, file)).join(", "))
    : t("A click beside a line number, or F9, sets a breakpoint.");
}

const lineText = ({ file: own, line }: Breakpoint, file: string): string =>
  own === file ? `${line}` : t("{0} of {1}", line, own);
