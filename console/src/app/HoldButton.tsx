import { hold, resume } from "../actions/machine";
import { ActionButton } from "../ui/ActionButton";
import { useShown } from "./context";

/** Hold while something moves, resume while it is held: one place for both. */
export function HoldButton() {
  const held = useShown((shown) => shown.snapshot?.machine.state === "held");
  return held ? (
    <ActionButton action={resume} look="go" className="hold-button" />
  ) : (
    <ActionButton action={hold} look="hold" className="hold-button" />
  );
}
