import { Button as AriaButton, type ButtonProps as AriaProps } from "react-aria-components";
import "./button.css";

export interface ButtonProps extends AriaProps {
  /** What pressing it means: `go` starts, `hold` pauses, `plain` is everything else. */
  look?: "plain" | "go" | "hold" | "quiet" | "primary";
  size?: "normal" | "large" | "small";
}

export function Button({ look = "plain", size = "normal", className, ...rest }: ButtonProps) {
  const extra = typeof className === "string" ? className : "";
  return <AriaButton {...rest} className={`button button-${look} button-${size} ${extra}`} />;
}
