import { useEffect, useMemo } from "react";
import { useHands } from "../app/context";
import { leaseOf, serverClockMs } from "../link/shown";
import { JogHand } from "./jog";

/** The handle of this page, which lets go whenever nobody can be holding it. */
export function useJog(): JogHand {
  const hands = useHands();
  const hand = useMemo(
    () =>
      new JogHand(
        (act) => hands.link.ask(act),
        () => leaseOf(hands.link.shown.get()),
        () => serverClockMs(hands.link.shown.get()),
        (why) => hands.screen.tell(why),
      ),
    [hands],
  );
  useEffect(() => {
    const release = () => hand.release();
    const hidden = () => document.hidden && hand.release();
    addEventListener("blur", release);
    addEventListener("pagehide", release);
    document.addEventListener("visibilitychange", hidden);
    return () => {
      removeEventListener("blur", release);
      removeEventListener("pagehide", release);
      document.removeEventListener("visibilitychange", hidden);
      hand.release();
    };
  }, [hand]);
  return hand;
}
