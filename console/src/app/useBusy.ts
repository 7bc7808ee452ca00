import { whenIdle } from "../actions/machine";
import { useHands, useShown } from "./context";

/** The reason for which nothing can be begun now; nothing while the machine is idle. */
export function useBusy(): string | undefined {
  const { link, screen } = useHands();
  return useShown((shown) => whenIdle({ shown, link, screen }));
}
