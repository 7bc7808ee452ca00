import { useEffect } from "react";
import { attempt, perform } from "../actions/action";
import { actionOfKey } from "../actions/keys";
import { actions } from "../actions/registry";
import { useHands, worldOf } from "./context";

/** Whether keys go into a field. */
const typingIn = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement &&
  (target.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(target.tagName));

/** Whether a key presses what has the focus. */
const presses = (target: EventTarget | null, key: string): boolean =>
  key === " " &&
  target instanceof HTMLElement &&
  target.closest("button, [role=button], a") !== null;

/** Hears the keys of the whole page. */
export function Keys() {
  const hands = useHands();
  useEffect(() => {
    const hear = (event: KeyboardEvent) => {
      if (event.defaultPrevented || presses(event.target, event.key)) return;
      const world = worldOf(hands);
      const { route } = hands.screen.get();
      const action = actionOfKey(actions, event, typingIn(event.target), route);
      if (!action) return;
      if (perform(action, world)) event.preventDefault();
      else if (action.keysTell) attempt(action, world);
    };
    addEventListener("keydown", hear);
    return () => removeEventListener("keydown", hear);
  }, [hands]);
  return null;
}
