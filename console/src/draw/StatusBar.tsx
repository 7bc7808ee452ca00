import { placeText } from "../app/units";
import { type LengthUnit, mm } from "../units/quantity";
import { KeyButtons } from "./KeyButtons";
import { promptOf } from "./prompt";
import type { Desk } from "./useDesk";

interface StatusBarProps {
  desk: Desk;
  unit: LengthUnit;
  /** After a button was pressed: keys are heard by the sheet again. */
  onPress: () => void;
}

/** Shows the question of the tool, its keys, and the place of the mouse. */
export function StatusBar({ desk, unit, onPress }: StatusBarProps) {
  const { state } = desk;
  const { title, words, snap } = promptOf(state);
  return (
    <footer className="sheet-status">
      <p className="sheet-status-prompt" role="status">
        <strong>{title}</strong> {words}
      </p>
      <p className="sheet-status-place">
        {state.pointer && placeText([mm(state.pointer.x), mm(state.pointer.y)], unit, 3)}
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
