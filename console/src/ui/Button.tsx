import { useContext } from "react";
import { Button as AriaButton, type ButtonProps as AriaProps } from "react-aria-components";
import { HandsContext } from "../app/context";
import { useWords } from "../app/useWords";
import { t } from "../words/words";
import "./button.css";

export interface ButtonProps extends Omit<AriaProps, "isDisabled"> {
  /** Meaning of a press: `go` starts, `hold` pauses, `plain` is everything else. */
  look?: "plain" | "go" | "hold" | "quiet" | "primary";
  size?: "normal" | "large" | "small";
  /** The reason for which it cannot be pressed now: it is greyed, and says so to a hand that tries. Nothing when it can. */
  refused?: string | undefined;
  /** A hand tried while it is refused, and was told why. */
  onRefused?: (() => void) | undefined;
}

/** The texts of a button, in the language of the page. */
function spoken({ children, "aria-label": label }: AriaProps) {
  return {
    ...(typeof children === "string" ? { children: t(children) } : {}),
    ...(label === undefined ? {} : { "aria-label": t(label) }),
  };
}

/** A button. One that may be refused stands in a place that tells why. */
export function Button(props: ButtonProps) {
  const { look = "plain", size = "normal", className, refused, onRefused, ...rest } = props;
  const screen = useContext(HandsContext)?.screen;
  const words = useWords();
  const extra = typeof className === "string" ? className : "";
  const button = (
    <AriaButton
      {...rest}
      {...spoken(rest)}
      isDisabled={refused !== undefined}
      className={`button button-${look} button-${size} ${extra}`}
    />
  );
  if (!("refused" in props)) return button;
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: a finger sees no title
    // biome-ignore lint/a11y/useKeyWithClickEvents: what has the focus can be pressed
    <span
      className="action-place"
      title={refused && words(t(refused))}
      onClick={() => {
        if (refused === undefined) return;
        screen?.tell(refused);
        onRefused?.();
      }}
    >
      {button}
    </span>
  );
}
