import { arm, disarm } from "../actions/machine";
import { ActionButton } from "../ui/ActionButton";
import { useShown } from "./context";

/** Allows motion, or forbids it, while the machine stands. */
export function ArmButton() {
  const state = useShown((shown) => shown.snapshot?.machine.state);
  const armed = useShown((shown) => shown.snapshot?.machine.armed);
  const idle = state === "idle";
  const stands = idle || state === "held" || state === "asking" || state === "stopped";
  if (!stands || (armed && !idle)) return null;
  return armed ? (
    <ActionButton action={disarm} size="small">
      Disarm
    </ActionButton>
  ) : (
    <ActionButton action={arm} size="small" look="primary">
      Arm
    </ActionButton>
  );
}
