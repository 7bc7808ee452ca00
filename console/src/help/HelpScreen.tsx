import { useState } from "react";
import { actions } from "../actions/registry";
import { useCommands } from "../command/table";
import { keyHelp } from "../keypad/keys";
import { Field } from "../ui/Field";
import { Panel } from "../ui/Panel";
import type { CommandEntry } from "../wire/messages";
import "./help.css";

/** Keys, and what every command does. */
export function HelpScreen() {
  return (
    <div className="help">
      <h1>Help</h1>
      <div className="help-columns">
        <div className="help-keys">
          <Panel title="Keys">
            <dl className="help-list">
              {actions
                .filter(({ keys }) => keys)
                .map(({ id, keys, title }) => (
                  <div key={id}>
                    <dt>
                      {keys?.map((key) => (
                        <kbd key={key}>{key}</kbd>
                      ))}
                    </dt>
                    <dd>{title}</dd>
                  </div>
                ))}
            </dl>
          </Panel>
          <Panel title="Keys of the keypad">
            <dl className="help-list">
              {keyHelp.map(({ keys, means }) => (
                <div key={keys}>
                  <dt>{keys}</dt>
                  <dd>{means}</dd>
                </div>
              ))}
            </dl>
          </Panel>
        </div>
        <CommandReference />
      </div>
    </div>
  );
}

function CommandReference() {
  const table = useCommands();
  const [wanted, setWanted] = useState("");
  return (
    <Panel title="Commands of OpenSBP" className="help-commands">
      <div className="help-search">
        <Field label="Look for" value={wanted} onChange={setWanted} placeholder="circle" />
      </div>
      <ul>
        {table
          .filter((entry) => tells(entry, wanted))
          .map(({ letters, name, doc, parameters }) => (
            <li key={letters}>
              <h2>
                <code>{letters}</code> {name}
              </h2>
              <p>{doc}</p>
              {parameters.length > 0 && (
                <p className="help-parameters">
                  {[letters, ...parameters.map((parameter) => parameter.name)].join(", ")}
                </p>
              )}
            </li>
          ))}
      </ul>
    </Panel>
  );
}

const tells = ({ letters, name, doc }: CommandEntry, wanted: string): boolean =>
  `${letters} ${name} ${doc}`.toLowerCase().includes(wanted.trim().toLowerCase());
