import { useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import { type Action, attempt } from "../actions/action";
import { keysOf } from "../actions/bindings";
import { actions } from "../actions/registry";
import { useHands, worldOf } from "../app/context";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import "./tools.css";

/** Every action by its name (Ctrl K). */
export function Palette({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const [wanted, setWanted] = useState("");
  const found = actions.filter((action) => named(action, wanted));
  const run = (action: Action | undefined) => {
    if (!action) return;
    onClose();
    attempt(action, worldOf(hands));
  };
  return (
    <Sheet title="Every action" onClose={onClose}>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          run(found[0]);
        }}
      >
        <Field label="What to do" value={wanted} onChange={setWanted} first />
      </form>
      <ListBox
        aria-label={t("Actions")}
        className="palette"
        selectionMode="none"
        onAction={(id) => run(found.find((action) => action.id === id))}
      >
        {found.map((action) => (
          <ListBoxItem
            key={action.id}
            id={action.id}
            className="palette-row list-row"
            textValue={action.title}
          >
            <span>{action.title}</span>
            <span>
              {keysOf(action).map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </span>
          </ListBoxItem>
        ))}
      </ListBox>
    </Sheet>
  );
}

/** Tells whether every word that is wanted stands in the title. */
const named = ({ title }: Action, wanted: string): boolean =>
  wanted
    .toLowerCase()
    .split(/\s+/)
    .every((word) => title.toLowerCase().includes(word));
