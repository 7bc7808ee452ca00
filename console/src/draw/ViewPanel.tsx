import { Panel } from "../ui/Panel";
import { optionWords, type ViewOption, type ViewOptions } from "./options";

interface ViewPanelProps {
  options: ViewOptions;
  onChange: (options: ViewOptions) => void;
}

/** Switches for the parts of the picture that are drawn. */
export function ViewPanel({ options, onChange }: ViewPanelProps) {
  return (
    <Panel title="View">
      <div className="view-options">
        {(Object.keys(optionWords) as ViewOption[]).map((option) => (
          <label key={option} title={optionWords[option].doc}>
            <input
              type="checkbox"
              checked={options[option]}
              onChange={() => onChange({ ...options, [option]: !options[option] })}
            />
            {optionWords[option].title}
          </label>
        ))}
      </div>
    </Panel>
  );
}
