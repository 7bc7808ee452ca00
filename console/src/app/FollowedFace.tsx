import { useEffect, useRef } from "react";
import { useHands } from "./context";
import { useDisplay } from "./display";

/** The face follows the machine's display setting (VD) whenever that changes; else it is this browser's. */
export function FollowedFace() {
  const { screen } = useHands();
  const easy = useDisplay()?.easy;
  const before = useRef<boolean>(undefined);
  useEffect(() => {
    if (easy === undefined) return;
    if (before.current !== undefined && before.current !== easy) {
      screen.face(easy ? "easy" : "full");
    }
    before.current = easy;
  }, [easy, screen]);
  return null;
}
