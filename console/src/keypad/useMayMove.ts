import { useShown } from "../app/context";
import { refusal } from "./refusal";

/** Above this round trip a hand that lets go is heard too late, milliseconds. */
const slowMs = 150;

export interface MayMove {
  /** Reason that the keypad does not move; nothing when it does. */
  readonly refused: string | undefined;
  /** Only fixed distances: the link is slow. */
  readonly onlySteps: boolean;
}

export const useMayMove = (): MayMove => ({
  refused: useShown(refusal),
  onlySteps: useShown(({ roundTripMs }) => (roundTripMs ?? 0) > slowMs),
});
