import { useEffect, useRef } from "react";
import { useHands, useSnapshot } from "./context";

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
    if (start.sheet) screen.open({ kind: "command", letters: "FP", given: [start.file] });
  }, [start, screen]);
  return null;
}
