import type { PointerEvent } from "react";
import { t } from "../words/words";
import type { Way } from "./keys";

interface JogButtonsProps {
  isDisabled: boolean;
  onHold: (way: Way, fast: boolean) => void;
  onRelease: () => void;
}

/** As they lie on the pad, row by row. */
const pad: readonly { readonly way: Way; readonly sign: string; readonly name: string }[] = [
  { way: "leftUp", sign: "↖", name: "X minus, Y plus" },
  { way: "up", sign: "Y+", name: "Y plus" },
  { way: "rightUp", sign: "↗", name: "X plus, Y plus" },
  { way: "raise", sign: "Z+", name: "Z up" },
  { way: "left", sign: "X−", name: "X minus" },
  { way: "right", sign: "X+", name: "X plus" },
  { way: "leftDown", sign: "↙", name: "X minus, Y minus" },
  { way: "down", sign: "Y−", name: "Y minus" },
  { way: "rightDown", sign: "↘", name: "X plus, Y minus" },
  { way: "lower", sign: "Z−", name: "Z down" },
];

/** Buttons that move while they are pressed; with Ctrl or Shift at jog speed. */
export function JogButtons({ isDisabled, onHold, onRelease }: JogButtonsProps) {
  const press = (way: Way) => (event: PointerEvent) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    onHold(way, event.ctrlKey || event.shiftKey);
  };
  return (
    <fieldset className="jog" aria-label={t("Move while held")}>
      {pad.map(({ way, sign, name }) => (
        <button
          key={way}
          type="button"
          className={`jog-button jog-${way}`}
          aria-label={name}
          disabled={isDisabled}
          onPointerDown={press(way)}
          onPointerUp={onRelease}
          onPointerCancel={onRelease}
          onLostPointerCapture={onRelease}
          onContextMenu={(event) => event.preventDefault()}
        >
          {sign}
        </button>
      ))}
    </fieldset>
  );
}
