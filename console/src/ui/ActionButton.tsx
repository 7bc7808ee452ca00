import type { ReactNode } from "react";
import { useCallback } from "react";
import { type Action, attempt } from "../actions/action";
import { useHands, useShown, worldOf } from "../app/context";
import type { Shown } from "../link/shown";
import { Button, type ButtonProps } from "./Button";

interface ActionButtonProps
  extends Omit<ButtonProps, "children" | "onPress" | "refused" | "onRefused"> {
  action: Action;
  /** Content of the button in place of the action's title. */
  children?: ReactNode;
}

/** A button that does an action, and is greyed when it cannot be done; a press on it then tells why. */
export function ActionButton({ action, children, ...rest }: ActionButtonProps) {
  const hands = useHands();
  const { screen, link } = hands;
  const refused = useShown(
    useCallback(
      (shown: Shown) => action.refused?.({ shown, link, screen }),
      [action, link, screen],
    ),
  );
  return (
    <Button
      {...rest}
      refused={refused}
      onRefused={() => action.mends?.(worldOf(hands))}
      onPress={() => attempt(action, worldOf(hands))}
    >
      {children ?? action.title}
    </Button>
  );
}
