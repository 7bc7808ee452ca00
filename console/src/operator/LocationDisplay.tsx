import { useState } from "react";
import { asking } from "../actions/action";
import { zeroAxis } from "../actions/machine";
import { useScreen, useSnapshot } from "../app/context";
import { locationText, usedAxes } from "../app/units";
import { ActionButton } from "../ui/ActionButton";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import type { AxisUnits, Positions } from "../wire/messages";
import "./location-display.css";

type Frame = "working" | "base";

const frames: readonly { value: Frame; words: string }[] = [
  { value: "working", words: "Working" },
  { value: "base", words: "Base" },
];

/** Where the tool is, in digits that are read from two metres away. */
export function LocationDisplay() {
  const [frame, setFrame] = useState<Frame>("working");
  const units = useSnapshot("units");
  const motion = useSnapshot("motion");
  const axes = units ? usedAxes(units) : [];
  return (
    <Panel
      title={frame === "working" ? "Location" : "Table base location"}
      className={`location location-${frame} location-of-${Math.max(axes.length, 3)}`}
      aside={<Choice label="Frame" options={frames} value={frame} onChange={setFrame} />}
    >
      <ul className="location-axes">
        {motion &&
          axes.map(({ axis, at }) => (
            <AxisRow key={axis.letter} axis={axis} at={at} positions={motion.at} frame={frame} />
          ))}
      </ul>
    </Panel>
  );
}

/** Characters of a location on a usual table: `-12.345`. */
const usualLength = 7;

interface AxisRowProps {
  axis: AxisUnits;
  at: number;
  positions: Positions;
  frame: Frame;
}

function AxisRow({ axis, at, positions, frame }: AxisRowProps) {
  const other = frame === "working" ? "base" : "working";
  const easy = useScreen("face") === "easy";
  const zero = zeroAxis[at] && easy ? asking(zeroAxis[at]) : zeroAxis[at];
  const text = locationText(positions[frame][at] ?? 0, axis);
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
      <span className="location-other">
        {other} {locationText(positions[other][at] ?? 0, axis)}
      </span>
      {zero && (
        <ActionButton action={zero} size="small" className="location-zero" aria-label={zero.title}>
          Zero
        </ActionButton>
      )}
    </li>
  );
}
