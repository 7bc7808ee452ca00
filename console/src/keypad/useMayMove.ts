import { useShown } from "../app/context";
import type { Shown } from "../link/shown";

/** Above this round trip a hand that lets go is heard too late, milliseconds. */
const slowMs = 150;

export interface MayMove {
  /** Why the keypad does not move; nothing when it does. */
  readonly refused: string | undefined;
  /** Only fixed distances: the link is slow. */
  readonly onlySteps: boolean;
}

export const useMayMove = (): MayMove => ({
  refused: useShown(refusal),
  onlySteps: useShown(({ roundTripMs }) => (roundTripMs ?? 0) > slowMs),
});

/** The keypad works connected, armed and not in preview. */
export function refusal({ status, snapshot }: Shown): string | undefined {
  if (status !== "open" || !snapshot) return "There is no link to the machine.";
  const { state, armed, mode } = snapshot.machine;
  if (mode === "preview") return "Nothing moves in preview: switch to move mode (SM).";
  if (!armed) return "Arm the machine first.";
  const kind = snapshot.asked?.kind;
  const inFile =
    (state === "asking" && kind === "keypad") || (state === "stopped" && kind === "hold");
  if (state === "idle" || state === "jogging" || inFile) return undefined;
  return "The machine is busy.";
}
