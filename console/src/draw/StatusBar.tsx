import type { Units } from "../wire/messages";
import type { DeskState } from "./desk";
import { promptOf } from "./prompt";

interface StatusBarProps {
  state: DeskState;
  units: Units | undefined;
}

/** What is asked, which snaps there are, and where the mouse is. */
export function StatusBar({ state, units }: StatusBarProps) {
  const { title, words, keys, snap } = promptOf(state);
  const mm = units?.mm ?? 1;
  const text = (value: number) => (value / mm).toFixed(3);
  return (
    <footer className="sheet-status">
      <p className="sheet-status-prompt" role="status">
        <strong>{title}</strong> {words}
      </p>
      {keys && (
        <p
          className="sheet-status-keys"
          title="Keys before a pick: vertex, centre, midpoint, intersection, nearest, square, none"
        >
          {[...keys].map((key) => (
            <kbd key={key} data-on={snap?.startsWith(key.toLowerCase()) || undefined}>
              {key}
            </kbd>
          ))}
          <span>{snap ?? "no snap"}</span>
        </p>
      )}
      <p className="sheet-status-place">
        {state.pointer &&
          `${text(state.pointer.x)}, ${text(state.pointer.y)} ${units?.linear ?? "mm"}`}
      </p>
    </footer>
  );
}
