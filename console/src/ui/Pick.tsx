import "./pick.css";

interface PickProps {
  label: string;
  options: readonly { readonly value: string; readonly words: string }[];
  value: string;
  onChange: (value: string) => void;
}

/** One of many, from a list that the system draws: nothing of ours covers STOP. */
export function Pick({ label, options, value, onChange }: PickProps) {
  const known = options.some((option) => option.value === value);
  return (
    <select
      className="pick"
      aria-label={label}
      value={value}
      onChange={(event) => onChange(event.target.value)}
    >
      {!known && <option value={value}>{value}</option>}
      {options.map((option) => (
        <option key={option.value} value={option.value}>
          {option.words}
        </option>
      ))}
    </select>
  );
}
