import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { evaluate } from "../app/expression";
import { usedAxes } from "../app/units";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { isMetric, ofAxisUnit, shownOnAxis } from "../units/quantity";
import type { AxisUnits } from "../wire/messages";
import { t } from "../words/words";
import "./tools.css";

/** Shifts the workpiece a little (MN), also while a part file is stopped. */
export function NudgeSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const units = useSnapshot("units");
  const [typed, setStep] = useState<string | null>(null);
  if (!units) return null;
  const step = typed ?? (isMetric(units) ? "0.25" : "0.01");
  const nudge = (axis: AxisUnits, sign: 1 | -1) => {
    const way = shownOnAxis((evaluate(step, units) ?? 0) * sign);
    void drive(worldOf(hands), {
      do: "nudge",
      axis: axis.letter,
      distance: ofAxisUnit(way, axis),
    });
  };
  return (
    <Sheet title="Nudge" shape="side" onClose={onClose}>
      <p className="tool-words">
        {t(
          "Moves tool and working zero together: what is cut next is shifted, what the display calls a place stays.",
        )}
      </p>
      <Field label="Distance" value={step} onChange={setStep} unit={units.linear} first />
      <div className="nudge">
        {usedAxes(units).map(({ axis }) => (
          <div key={axis.letter} className="nudge-axis">
            <Button size="large" onPress={() => nudge(axis, -1)}>
              {axis.letter} −
            </Button>
            <Button size="large" onPress={() => nudge(axis, 1)}>
              {axis.letter} +
            </Button>
          </div>
        ))}
      </div>
    </Sheet>
  );
}
