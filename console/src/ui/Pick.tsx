import { t } from "../words/words";
import "./pick.css";

interface PickProps {
  label: string;
  options: readonly { readonly value: string; readonly words: string }[];
  value: string;
  onChange: (value: string) => void;
  /** The label stands above it; else only who does not see it is told. */
  labelled?: boolean;
}

/** One of many, from a list that the system draws: nothing of ours covers STOP. */
export function Pick({ label, options, value, onChange, labelled = false }: PickProps) {
  const known = options.some((option) => option.value === value);
  const list = (
    <select
      className="pick"
      aria-label={t(label)}
      value={value}
      onChange={(event) => onChange(event.target.value)}
    >
      {!known && <option value={value}>{value}</option>}
      {options.map((option) => (
        <option key={option.value} value={option.value}>
          {t(option.words)}
        </option>
      ))}
    </select>
  );
  if (!labelled) return list;
  return (
    <div className="field">
      <span className="field-label" aria-hidden="true">
        {t(label)}
      </span>
      {list}
    </div>
  );
}
