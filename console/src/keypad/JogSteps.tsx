import { ToggleButton, ToggleButtonGroup } from "react-aria-components";
import { resultText } from "../app/expression";
import { isMetric } from "../units/quantity";
import type { Units } from "../wire/messages";
import { t } from "../words/words";

interface JogStepsProps {
  units: Units;
  /** The distance in force, in the unit of the page; nothing while the tool moves as long as it is held. */
  step: number | null;
  onStep: (step: number) => void;
}

/** Steps that a press makes, in the unit of the page. */
const metric = [0.01, 0.1, 1, 10] as const;
const imperial = [0.001, 0.01, 0.1, 1] as const;

/** The usual distances, one press each. */
export function JogSteps({ units, step, onStep }: JogStepsProps) {
  const steps = isMetric(units) ? metric : imperial;
  return (
    <ToggleButtonGroup
      className="choice jog-steps"
      aria-label={t("Steps, {0}", units.linear)}
      selectionMode="single"
      selectedKeys={step === null ? [] : [String(step)]}
      onSelectionChange={([key]) => onStep(key === undefined ? (step ?? steps[0]) : Number(key))}
    >
      {steps.map((one) => (
        <ToggleButton key={one} id={String(one)} className="choice-one">
          {resultText(one)}
        </ToggleButton>
      ))}
      <span className="jog-steps-unit">{units.linear}</span>
    </ToggleButtonGroup>
  );
}
