import { useEffect, useRef, useState } from "react";
import { evaluate, resultText } from "../app/expression";
import { Field } from "../ui/Field";
import { t } from "../words/words";

export interface ValueFieldProps {
  label: string;
  /** In the unit that is shown. */
  value: number;
  unit?: string;
  isDisabled?: boolean;
  onSet: (value: number) => Promise<boolean>;
}

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
