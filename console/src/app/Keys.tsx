import { useLayoutEffect } from "react";
import { attempt, perform } from "../actions/action";
import { actionOfKey } from "../actions/keys";
import { hold, spaceBar } from "../actions/machine";
import { actions } from "../actions/registry";
import { otherVersion } from "../link/version";
import { useHands, worldOf } from "./context";
import { isSwitch, leave, takesKeys, takesText } from "./typing";

/** Hears the keys of the whole page, from the moment at which it is shown: none is lost before. */
export function Keys() {
  useSpaceBar();
  useFields();
  const hands = useHands();
  useLayoutEffect(() => {
    const hear = (event: KeyboardEvent) => {
      if (event.defaultPrevented) return;
      const world = worldOf(hands);
      const known = otherVersion(world.shown) === undefined ? actions : [hold];
      const action = actionOfKey(known, event, takesKeys(event.target), world);
      if (!action) return;
      if (perform(action, world)) event.preventDefault();
      else if (action.keysTell) attempt(action, world);
    };
    addEventListener("keydown", hear);
    return () => removeEventListener("keydown", hear);
  }, [hands]);
  return null;
}

/**
 * The space bar is STOP, whatever has the focus and whatever is held beside it, but for fields of text. It is heard
 * before anything else hears it, and nothing else does: no button is pressed and no list opened by it. Enter does
 * that.
 */
function useSpaceBar(): void {
  const hands = useHands();
  useLayoutEffect(() => {
    const hear = (event: KeyboardEvent) => {
      if (event.key !== " " || takesText(event.target)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      if (event.type === "keydown" && !event.repeat) perform(spaceBar, worldOf(hands));
    };
    // Some browsers press a button when the key is let go.
    addEventListener("keydown", hear, true);
    addEventListener("keyup", hear, true);
    return () => {
      removeEventListener("keydown", hear, true);
      removeEventListener("keyup", hear, true);
    };
  }, [hands]);
}

/** Escape leaves a field of text, so that the space bar is STOP; Enter switches what the space bar did. */
function useFields(): void {
  useLayoutEffect(() => {
    const hear = (event: KeyboardEvent) => {
      const { key, target, defaultPrevented } = event;
      if (defaultPrevented) return;
      if (key === "Enter" && isSwitch(target)) {
        event.preventDefault();
        if (!event.repeat) target.click();
      }
      if (key !== "Escape" || !takesText(target)) return;
      // A sheet may close with its field; what still has the focus then is left.
      setTimeout(() => document.activeElement === target && leave(target));
    };
    addEventListener("keydown", hear);
    return () => removeEventListener("keydown", hear);
  }, []);
}
