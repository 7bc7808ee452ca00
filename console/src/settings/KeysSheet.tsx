import { type KeyboardEvent, useState } from "react";
import type { Action } from "../actions/action";
import { bind, isFixed, isRebound, keysOf, refusedKey, unbindAll } from "../actions/bindings";
import { keyName } from "../actions/keys";
import { actions } from "../actions/registry";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";

/** The keys of all actions, to be changed. They are kept by this browser. */
export function KeysSheet({ onClose }: { onClose: () => void }) {
  const [wanted, setWanted] = useState("");
  const [changes, setChanges] = useState(0);
  const changed = () => setChanges(changes + 1);
  const word = wanted.trim().toLowerCase();
  const found = actions.filter(({ title }) => title.toLowerCase().includes(word));
  return (
    <Sheet
      title="Keys of actions"
      onClose={onClose}
      foot={
        <Button
          refused={actions.some(isRebound) ? undefined : t("No key was changed.")}
          onPress={() => {
            unbindAll();
            changed();
          }}
        >
          Usual keys
        </Button>
      }
    >
      <p className="tool-words">
        {t(
          "Press a button, then the key; Delete takes it away. The space bar is STOP and stays it.",
        )}
      </p>
      <Field label="Search" value={wanted} onChange={setWanted} first />
      <ul className="keys-list">
        {found.map((action) => (
          <li key={action.id} className="list-line">
            <span>{action.title}</span>
            <KeyOf key={`${action.id} ${changes}`} action={action} onChange={changed} />
          </li>
        ))}
      </ul>
    </Sheet>
  );
}

const modifiers = ["Control", "Shift", "Alt", "Meta", "AltGraph"];

/** The key of an action. A press listens for another one. */
function KeyOf({ action, onChange }: { action: Action; onChange: () => void }) {
  const [listens, setListens] = useState(false);
  const [refused, setRefused] = useState<string>();
  const keys = keysOf(action);
  if (isFixed(action)) return <Keys keys={keys} />;
  const hear = (event: KeyboardEvent) => {
    const key = keyName(event);
    if (!listens || modifiers.includes(event.key) || key === "Tab" || key === "Shift+Tab") return;
    event.preventDefault();
    if (key === "Escape") return setListens(false);
    const without = key === "Delete" || key === "Backspace";
    const why = without ? undefined : refusedKey(actions, action, key);
    setRefused(why);
    if (why !== undefined) return;
    bind(action, without ? undefined : key);
    onChange();
  };
  return (
    <>
      <button
        type="button"
        className="keys-of"
        aria-label={t("Key of {0}: {1}", action.title, listens ? t("Press a key") : keys.join(" "))}
        aria-pressed={listens}
        onClick={() => setListens(true)}
        onBlur={() => setListens(false)}
        onKeyDown={hear}
      >
        {listens ? t("Press a key") : keys.length > 0 ? <Keys keys={keys} /> : "–"}
      </button>
      {refused !== undefined && (
        <p role="alert" className="keys-refused">
          {refused}
        </p>
      )}
    </>
  );
}

const Keys = ({ keys }: { keys: readonly string[] }) =>
  keys.map((key) => (
    <span key={key}>
      <kbd>{key}</kbd>{" "}
    </span>
  ));
