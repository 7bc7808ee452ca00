import { evaluate } from "../app/expression";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import type { Units } from "../wire/messages";
import { JogSteps } from "./JogSteps";

/** The tool moves as long as it is held, or so far with each press. */
export type Manner = "hold" | "distance";

const manners: readonly { value: Manner; words: string }[] = [
  { value: "hold", words: "While held" },
  { value: "distance", words: "Fixed distance" },
];

interface JogMannerProps {
  units: Units;
  manner: Manner;
  /** The fixed distance as it is typed, in the unit of the page. */
  step: string;
  onChange: (manner: Manner, step: string) => void;
}

/** Chooses how a hand moves the tool, and how far with a press. */
export function JogManner({ units, manner, step, onChange }: JogMannerProps) {
  const isFixed = manner === "distance";
  return (
    <>
      <div className="keypad-manner">
        <Choice
          label="Motion"
          options={manners}
          value={manner}
          onChange={(next) => onChange(next, step)}
        />
        {isFixed && (
          <Field
            label="Distance"
            value={step}
            onChange={(next) => onChange(manner, next)}
            unit={units.linear}
          />
        )}
      </div>
      <JogSteps
        units={units}
        step={isFixed ? (evaluate(step, units) ?? null) : null}
        onStep={(next) => onChange("distance", String(next))}
      />
    </>
  );
}
