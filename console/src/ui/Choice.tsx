import { ToggleButton, ToggleButtonGroup } from "react-aria-components";
import { t } from "../words/words";
import "./choice.css";

interface ChoiceProps<T extends string> {
  label: string;
  options: readonly { readonly value: T; readonly words: string }[];
  value: T;
  onChange: (value: T) => void;
  isDisabled?: boolean;
  /** Has the focus when its sheet opens. */
  first?: boolean;
}

/** One of a few, all in sight. */
export function Choice<T extends string>({
  label,
  options,
  value,
  onChange,
  isDisabled,
  first,
}: ChoiceProps<T>) {
  return (
    <ToggleButtonGroup
      className="choice"
      aria-label={t(label)}
      selectionMode="single"
      disallowEmptySelection
      isDisabled={isDisabled ?? false}
      selectedKeys={[value]}
      onSelectionChange={([key]) => {
        const chosen = options.find((option) => option.value === key);
        if (chosen) onChange(chosen.value);
      }}
    >
      {options.map((option) => (
        <ToggleButton
          key={option.value}
          id={option.value}
          className="choice-one"
          data-first={(first && option.value === value) || undefined}
        >
          {t(option.words)}
        </ToggleButton>
      ))}
    </ToggleButtonGroup>
  );
}
