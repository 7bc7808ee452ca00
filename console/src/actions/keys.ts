/** Finds the action of a key. */

import type { Action, World } from "./action";
import { keysOf } from "./bindings";

/** The parts of a `KeyboardEvent` that tell which key it is. */
export interface KeyPress {
  readonly key: string;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly repeat: boolean;
}

/** `Ctrl+Shift+K`, `F10`, `i`: a letter alone is written small. */
export function keyName(press: KeyPress): string {
  const key = press.key === " " ? "Space" : press.key;
  const letter = key.length === 1 ? key.toLowerCase() : key;
  const shifted = press.shiftKey && (key.length > 1 || press.ctrlKey || press.metaKey);
  const parts = [
    press.ctrlKey || press.metaKey ? "Ctrl" : "",
    press.altKey ? "Alt" : "",
    shifted ? "Shift" : "",
    press.ctrlKey || press.metaKey ? letter.toUpperCase() : letter,
  ];
  return parts.filter((part) => part !== "").join("+");
}

/** The action of a key; one that has it only now before one that has it always. A held key means nothing: whatever it did is done already. */
export function actionOfKey(
  actions: readonly Action[],
  press: KeyPress,
  typing: boolean,
  world?: World,
): Action | undefined {
  if (press.repeat) return undefined;
  const name = keyName(press);
  const found = actions.filter(
    (a) => keysOf(a).includes(name) && (!typing || a.everywhere === true),
  );
  return found.find(({ when }) => world && when?.(world)) ?? found.find(({ when }) => !when);
}
