import { useState } from "react";
import { useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";
import { findCommand, useCommands } from "../command/table";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { CommandEntry, Values } from "../wire/messages";
import { parameterWords } from "../words/commands";
import { t } from "../words/words";
import "./tools.css";
import { VariableLines } from "./VariableLines";

type Kind = "variables" | "system" | "settings" | "diagnostics";

const kinds: readonly { value: Kind; words: string }[] = [
  { value: "variables", words: "Variables (UL)" },
  { value: "settings", words: "Settings (UV)" },
  { value: "diagnostics", words: "Diagnostics (UD)" },
  { value: "system", words: "System" },
];

/** Shows the machine's memory: user variables, system variables, settings. */
export function ValuesSheet({ first, onClose }: { first?: Kind | undefined; onClose: () => void }) {
  const values = useValues();
  // With the units that are set now.
  const table = useCommands(true);
  const [kind, setKind] = useState<Kind>(first ?? "variables");
  const [wanted, setWanted] = useState("");
  const [editing, setEditing] = useState(false);
  const rows = values ? rowsOf(values, kind, table) : [];
  const found = rows.filter((row) => row.join(" ").toLowerCase().includes(wanted.toLowerCase()));
  return (
    <Sheet title="Values" shape="wide" onClose={onClose}>
      <div className="values-head">
        <Choice label="Which values" options={kinds} value={kind} onChange={setKind} />
        <Field label="Look for" value={wanted} onChange={setWanted} first />
      </div>
      {kind === "variables" && values && !editing && (
        <Button size="small" onPress={() => setEditing(true)}>
          Change or add…
        </Button>
      )}
      {kind === "variables" && values && editing && (
        <VariableLines variables={values.variables} onDone={() => setEditing(false)} />
      )}
      <section className="values" aria-label={t("Values")} hidden={kind === "variables" && editing}>
        <table className="list-table">
          <tbody>
            {found.map(([name, value, words]) => (
              <tr key={name}>
                <th scope="row">{name}</th>
                <td>{value}</td>
                <td>{words}</td>
              </tr>
            ))}
          </tbody>
        </table>
        {found.length === 0 && <p className="tail-empty">{t("Nothing here has a value.")}</p>}
      </section>
    </Sheet>
  );
}

/** Name, value and what it is. */
type Row = [string, string, string];

function rowsOf(values: Values, kind: Kind, table: readonly CommandEntry[]): Row[] {
  switch (kind) {
    case "variables":
      return values.variables.map(({ name, value }) => [name, value, ""]);
    case "system":
      return values.system.map(({ number, name, unit, value }) => [
        `%(${number})`,
        value,
        unit ? `${name}, ${unit}` : name,
      ]);
    case "settings":
      return [
        [t("Part folder"), values.parts, values.folder.mask],
        [t("Data folder"), values.data, ""],
        ...values.settings.flatMap((line) => settingRows(line, table)),
      ];
    case "diagnostics":
      return values.diagnostics.map(({ name, value }) => [name, value, ""]);
  }
}

/** The line that sets values, and below it each of them with its name and unit. */
function settingRows(line: string, table: readonly CommandEntry[]): Row[] {
  const [letters = "", ...given] = line.split(",");
  const entry = findCommand(table, letters);
  const parts = given.map((value, n): Row | undefined => {
    const parameter = entry?.parameters[n];
    if (!parameter || value === "") return undefined;
    return [`${letters} ${n + 1}: ${parameterWords(parameter.name)}`, value, parameter.unit];
  });
  return [[line, "", entry?.name ?? ""], ...parts.filter((row) => row !== undefined)];
}

/** The values, read again after every job. */
function useValues(): Values | null {
  const job = useSnapshot("job");
  const changes = useSnapshot("settings");
  return useFetched<Values | null>("/api/values", null, `${job?.run} ${job?.ended} ${changes}`);
}
