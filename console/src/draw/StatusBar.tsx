import type { Units } from "../wire/messages";
import { KeyButtons } from "./KeyButtons";
import { promptOf } from "./prompt";
import type { Desk } from "./useDesk";

interface StatusBarProps {
  desk: Desk;
  units: Units | undefined;
  /** After a button was pressed: keys are heard by the sheet again. */
  onPress: () => void;
}

/** What is asked, which keys there are, and where the mouse is. */
export function StatusBar({ desk, units, onPress }: StatusBarProps) {
  const { state } = desk;
  const { title, words, snap } = promptOf(state);
  const mm = units?.mm ?? 1;
  const text = (value: number) => (value / mm).toFixed(3);
  return (
    <footer className="sheet-status">
      <p className="sheet-status-prompt" role="status">
        <strong>{title}</strong> {words}
      </p>
      <p className="sheet-status-place">
        {state.pointer &&
          `${text(state.pointer.x)}, ${text(state.pointer.y)} ${units?.linear ?? "mm"}`}
      </p>
      <div className="sheet-status-keys">
        <KeyButtons desk={desk} menu="snap" pressed={state.running?.snap ?? null} after={onPress} />
        {snap && <span>{snap}</span>}
        <KeyButtons desk={desk} menu="turn" after={onPress} />
        <KeyButtons desk={desk} menu="tool" after={onPress} />
      </div>
    </footer>
  );
}
