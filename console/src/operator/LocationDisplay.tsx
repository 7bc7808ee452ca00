import { useState } from "react";
import { type Action, asking } from "../actions/action";
import { zeroAxis } from "../actions/machine";
import { useScreen, useSnapshot } from "../app/context";
import { locationText, usedAxes } from "../app/units";
import { ActionButton } from "../ui/ActionButton";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import { type AxisValue, mm } from "../units/quantity";
import type { AxisUnits } from "../wire/messages";
import { t } from "../words/words";
import { type Frame, framesOf, placeIn, titles } from "./frames";
import "./location-display.css";

/** Shows the location of the tool, in digits that are read from two metres away. */
export function LocationDisplay() {
  const [wanted, setFrame] = useState<Frame | null>(null);
  const units = useSnapshot("units");
  const motion = useSnapshot("motion");
  const opened = useSnapshot("opened") ?? null;
  const job = useSnapshot("job") ?? null;
  const axes = units ? usedAxes(units) : [];
  const frames = framesOf(opened);
  // A job that is opened is told from its origin, until somebody looks for something else.
  const frame =
    frames.find(({ value }) => value === wanted)?.value ?? frames[0]?.value ?? "working";
  const other = frame === "working" ? "base" : "working";
  const otherName = other === "base" ? t("base") : t("working");
  return (
    <Panel
      title={titles[frame]}
      className={`location location-${frame} location-of-${Math.max(axes.length, 3)}`}
      aside={<Choice label="Frame" options={frames} value={frame} onChange={setFrame} />}
    >
      <ul className="location-axes">
        {motion &&
          axes.map(({ axis, at }) => (
            <AxisRow
              key={axis.letter}
              axis={axis}
              zero={frame === "job" ? undefined : zeroAxis[at]}
              value={placeIn(frame, motion, { opened, job })[at] ?? mm(0)}
              other={`${otherName} ${locationText(motion.at[other][at] ?? mm(0), axis)}`}
            />
          ))}
      </ul>
    </Panel>
  );
}

/** Characters of a location on a usual table: `-12.345`. */
const usualLength = 7;

interface AxisRowProps {
  axis: AxisUnits;
  value: AxisValue;
  /** The location in another frame, with its name. */
  other: string;
  /** Makes this the zero of the working location. */
  zero: Action | undefined;
}

function AxisRow({ axis, value, other, zero }: AxisRowProps) {
  const easy = useScreen("face") === "easy";
  const action = zero && easy ? asking(zero) : zero;
  const text = locationText(value, axis);
  return (
    <li className="location-axis">
      <span className="location-letter">{axis.letter}</span>
      <output
        className="location-number"
        data-axis={axis.letter}
        style={{ "--long": Math.max(text.length, usualLength) }}
      >
        {text}
      </output>
      <span className="location-unit">{axis.unit}</span>
      <span className="location-other">{other}</span>
      {action && (
        <ActionButton
          action={action}
          size="small"
          className="location-zero"
          aria-label={action.title}
        >
          Zero
        </ActionButton>
      )}
    </li>
  );
}
