import { useEffect, useRef, useState } from "react";
import { evaluate, resultText } from "../app/expression";
import { Field } from "../ui/Field";
import {
  inUnit,
  type LengthUnit,
  type Mm,
  type MmPerMin,
  type MmPerS,
  ofUnit,
  perMinute,
  perMinuteInUnit,
  perMinuteOfUnit,
  shown,
  shownPerMin,
} from "../units/quantity";
import { t } from "../words/words";

export interface ValueFieldProps {
  label: string;
  /** In the unit that is shown. */
  value: number;
  unit?: string;
  isDisabled?: boolean;
  onSet: (value: number) => Promise<boolean>;
}

/** A field of a length, in the unit of the page. */
export const lengthField = (
  label: string,
  length: Mm,
  unit: LengthUnit,
  onSet: (length: Mm) => Promise<boolean>,
): ValueFieldProps => ({
  label,
  value: inUnit(length, unit),
  unit: unit.linear,
  onSet: (typed) => onSet(ofUnit(shown(typed), unit)),
});

/** A field of a cutting speed, by the minute. */
export const speedField = (
  label: string,
  speed: MmPerS,
  unit: LengthUnit,
  onSet: (speed: MmPerMin) => Promise<boolean>,
): ValueFieldProps => ({
  label,
  value: perMinuteInUnit(perMinute(speed), unit),
  unit: `${unit.linear}/min`,
  onSet: (typed) => onSet(perMinuteOfUnit(shownPerMin(typed), unit)),
});

/** A number that is sent when the field is left or Enter pressed. */
export function ValueField({ label, value, unit, isDisabled = false, onSet }: ValueFieldProps) {
  const shown = resultText(Number(value.toFixed(4)));
  const [text, setText] = useState(shown);
  const [wrong, setWrong] = useState(false);
  // Enter sends it, and so does leaving the field a moment later: once is meant.
  const sending = useRef(false);
  useEffect(() => setText(shown), [shown]);
  const leave = async () => {
    if (sending.current) return;
    if (text.trim() === shown) return setWrong(false);
    const number = evaluate(text);
    setWrong(number === undefined);
    if (number === undefined) return;
    sending.current = true;
    try {
      if (!(await onSet(number))) setText(shown);
    } finally {
      sending.current = false;
    }
  };
  return (
    <form
      className="value-field"
      onSubmit={(event) => {
        event.preventDefault();
        void leave();
      }}
    >
      <Field
        label={label}
        value={text}
        onChange={setText}
        onBlur={() => void leave()}
        isDisabled={isDisabled}
        error={wrong ? t("This is no number.") : undefined}
        {...(unit ? { unit } : {})}
      />
    </form>
  );
}
