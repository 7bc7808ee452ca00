import { ParameterField } from "../command/ParameterField";
import { withEntry } from "../command/sheet";
import type { CommandEntry } from "../wire/messages";
import type { Maker } from "./useMaker";

interface EntryFieldsProps {
  entry: CommandEntry;
  maker: Maker;
  /** Places of the entries that are shown. */
  places: readonly number[];
}

/** The fields of some entries of a form. */
export function EntryFields({ entry, maker, places }: EntryFieldsProps) {
  const { entries, mistakes, setEntries } = maker;
  return (
    <div className="probe-fields">
      {places.map((n) => {
        const parameter = entry.parameters[n];
        return (
          parameter && (
            <ParameterField
              key={parameter.name}
              parameter={parameter}
              first={false}
              value={entries[n] ?? ""}
              mistake={mistakes.get(n)}
              onChange={(text) => setEntries(withEntry(entries, n, text))}
            />
          )
        );
      })}
    </div>
  );
}
