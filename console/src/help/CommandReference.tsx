import { useState } from "react";
import { useCommands } from "../command/table";
import { Field } from "../ui/Field";
import type { CommandEntry } from "../wire/messages";

/** Reference of every command, from the table of commands. */
export function CommandReference() {
  const table = useCommands();
  const [wanted, setWanted] = useState("");
  return (
    <div className="help-commands">
      <div className="help-search">
        <Field label="Look for" value={wanted} onChange={setWanted} placeholder="circle" />
      </div>
      <ul>
        {table
          .filter((entry) => tells(entry, wanted))
          .map(({ letters, name, doc, parameters }) => (
            <li key={letters}>
              <h3>
                <code>{letters}</code> {name}
              </h3>
              <p>{doc}</p>
              {parameters.length > 0 && (
                <p className="help-parameters">
                  {[letters, ...parameters.map((parameter) => parameter.name)].join(", ")}
                </p>
              )}
            </li>
          ))}
      </ul>
    </div>
  );
}

const tells = ({ letters, name, doc }: CommandEntry, wanted: string): boolean =>
  `${letters} ${name} ${doc}`.toLowerCase().includes(wanted.trim().toLowerCase());
