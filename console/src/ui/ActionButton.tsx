import type { ReactNode } from "react";
import { useCallback } from "react";
import { type Action, perform } from "../actions/action";
import { useHands, useShown, worldOf } from "../app/context";
import type { Shown } from "../link/shown";
import { Button, type ButtonProps } from "./Button";

interface ActionButtonProps extends Omit<ButtonProps, "children" | "onPress" | "isDisabled"> {
  action: Action;
  /** What stands on it instead of the action's title. */
  children?: ReactNode;
}

/** A button that does an action, and is greyed with the reason when it cannot be done. */
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
    <span className="action-place" title={refused}>
      <Button
        {...rest}
        isDisabled={refused !== undefined}
        onPress={() => perform(action, worldOf(hands))}
      >
        {children ?? action.title}
      </Button>
    </span>
  );
}
