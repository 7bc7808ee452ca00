import { useEffect } from "react";
import { openKeypad } from "../actions/go";
import { useHands, useShown, worldOf } from "../app/context";
import { KeypadSheet } from "./KeypadSheet";
import { busy, refusal } from "./refusal";

/** The keypad where the tool may not be moved yet: says why, and opens as soon as it may. */
export function KeypadWaits({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const refused = useShown(refusal);
  // biome-ignore lint/correctness/useExhaustiveDependencies: once, when nothing is in the way any more
  useEffect(() => {
    if (refused !== undefined && refused !== busy) return;
    // While something else goes on it is no longer waited for: it would open when nobody thinks of it.
    if (refused === undefined) openKeypad.run(worldOf(hands));
    onClose();
  }, [refused, hands]);
  return <KeypadSheet onClose={onClose} />;
}
