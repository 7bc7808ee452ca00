import { type PointerEvent, useState } from "react";
import { useSnapshot } from "../app/context";
import { usedAxes } from "../app/units";
import { t } from "../words/words";
import { type Direction, directionOf } from "./keys";

interface PendantProps {
  isDisabled: boolean;
  onHold: (direction: Direction, fast: boolean) => void;
  onRelease: () => void;
}

const [left, middle, right] = [0, 1, 2];

/** The mouse as a pendant: the left button moves an axis down, the right one up, the middle one takes the next axis. */
export function Pendant({ isDisabled, onHold, onRelease }: PendantProps) {
  const units = useSnapshot("units");
  const axes = units ? usedAxes(units) : [];
  const [chosen, setChosen] = useState(0);
  const active = axes[chosen % Math.max(axes.length, 1)];
  const press = (event: PointerEvent) => {
    event.preventDefault();
    if (event.button === middle) setChosen((now) => now + 1);
    if (!active || isDisabled || (event.button !== left && event.button !== right)) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    onHold(directionOf(active.at, event.button === right ? 1 : -1), event.ctrlKey);
  };
  return (
    <button
      type="button"
      className="pendant"
      onPointerDown={press}
      onPointerUp={onRelease}
      onPointerCancel={onRelease}
      onLostPointerCapture={onRelease}
      onContextMenu={(event) => event.preventDefault()}
      onAuxClick={(event) => event.preventDefault()}
    >
      <output className="pendant-axis">{active?.axis.letter}</output>
      {t("left button −, right button +, middle button next axis")}
    </button>
  );
}
