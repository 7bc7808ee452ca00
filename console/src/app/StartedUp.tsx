import { useEffect, useRef } from "react";
import { ask } from "../actions/ask";
import { useHands, useShown, useSnapshot, worldOf } from "./context";
import type { Sheet } from "./screen";

/** Follows the start-up line with which Kerf was started: the console on or off, the FP sheet on its file. */
export function StartedUp() {
  const { screen } = useHands();
  const start = useSnapshot("start");
  const followed = useRef(false);
  useEffect(() => {
    if (!start || followed.current) return;
    followed.current = true;
    if (start.display === 1) screen.face("full");
    if (start.display === 2) screen.face("easy");
  }, [start, screen]);
  const looksOnly = useShown((shown) => shown.who?.role === "observer");
  useFirstSheet(start?.sheet && !looksOnly ? start.file : undefined);
  return null;
}

/** The sheet waits, also when the page is loaded again, until it is filled in or put away on one page. */
function useFirstSheet(file: string | undefined) {
  const hands = useHands();
  useEffect(() => {
    if (file === undefined) return;
    const { screen } = hands;
    const sheet: Sheet = { kind: "command", letters: "FP", given: [file] };
    screen.open(sheet);
    const unwatch = screen.watch(() => {
      if (screen.get().sheet === sheet) return;
      unwatch();
      void ask(worldOf(hands), { do: "sheetDone" });
    });
    return () => {
      unwatch();
      screen.close(sheet);
    };
  }, [file, hands]);
}
