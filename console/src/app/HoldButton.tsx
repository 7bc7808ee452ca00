import { hold, resume, toolIn, touchOff } from "../actions/machine";
import { ActionButton } from "../ui/ActionButton";
import { useShown } from "./context";

/** Hold while something moves, resume while it is held, continue where a tool is waited for: one place for all. */
export function HoldButton() {
  const state = useShown((shown) => shown.snapshot?.machine.state);
  const wantsTool = useShown((shown) => shown.snapshot?.machine.wantsTool);
  const touchesOff = useShown((shown) => shown.snapshot?.machine.touchesOff);
  if (wantsTool && (state === "idle" || state === "running"))
    return (
      <>
        {touchesOff && (
          <ActionButton action={touchOff} className="hold-button">
            Touch off
          </ActionButton>
        )}
        <ActionButton action={toolIn} look="go" className="hold-button">
          Continue
        </ActionButton>
      </>
    );
  return state === "held" ? (
    <ActionButton action={resume} look="go" className="hold-button" />
  ) : (
    <ActionButton action={hold} look="hold" className="hold-button" />
  );
}
