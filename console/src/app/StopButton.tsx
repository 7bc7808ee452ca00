import { perform } from "../actions/action";
import { stop } from "../actions/machine";
import { useHands, worldOf } from "./context";
import "./stop-button.css";

/**
 * Always there, always enabled. It acts when it is touched, not when it is let go: a finger that
 * slips off has stopped the machine all the same.
 */
export function StopButton() {
  const hands = useHands();
  const press = () => void perform(stop, worldOf(hands));
  return (
    <button
      type="button"
      className="stop"
      aria-keyshortcuts="Space"
      onPointerDown={press}
      onKeyDown={(event) => {
        if (event.key !== "Enter") return;
        event.preventDefault();
        if (!event.repeat) press();
      }}
    >
      STOP
    </button>
  );
}
