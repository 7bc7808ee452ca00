import type { ReactNode } from "react";
import {
  FieldError,
  Input,
  Label,
  Text,
  TextField,
  type TextFieldProps,
} from "react-aria-components";
import { t } from "../words/words";
import "./field.css";

interface FieldProps extends Omit<TextFieldProps, "children"> {
  label: string;
  /** Stands behind the value: a unit. */
  unit?: string;
  hint?: ReactNode;
  error?: string | undefined;
  placeholder?: string;
  /** Has the focus when its sheet opens. */
  first?: boolean;
}

/** A labelled entry of one line. */
export function Field({ label, unit, hint, error, placeholder, first, ...rest }: FieldProps) {
  return (
    <TextField {...rest} isInvalid={error !== undefined} className="field">
      <Label className="field-label">
        {t(label)}
        {rest.isRequired && <Required />}
      </Label>
      <div className="field-box">
        <Input
          placeholder={t(placeholder ?? "")}
          data-first={first || undefined}
          autoComplete="off"
          spellCheck={false}
        />
        {unit && <span className="field-unit">{unit}</span>}
      </div>
      {hint && (
        <Text slot="description" className="field-hint">
          {typeof hint === "string" ? t(hint) : hint}
        </Text>
      )}
      <FieldError className="field-error">{error}</FieldError>
    </TextField>
  );
}

/** The mark of what has to be given. */
export const Required = () => (
  <span className="field-required" title={t("has to be given")}>
    *
  </span>
);
