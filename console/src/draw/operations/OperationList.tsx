import { useState } from "react";
import { drawingWords } from "../../app/drawingWords";
import { Field } from "../../ui/Field";
import { Sheet } from "../../ui/Sheet";
import type { OperationEntry } from "../../wire/messages";
import { titleOf } from "./OperationSheet";

interface OperationListProps {
  table: readonly OperationEntry[];
  onChoose: (name: string) => void;
  onClose: () => void;
}

/** Every operation of the table. */
export function OperationList({ table, onChoose, onClose }: OperationListProps) {
  const [sought, setSought] = useState("");
  const word = sought.trim().toLowerCase();
  const found = table.filter(({ name, doc }) => `${name} ${doc}`.toLowerCase().includes(word));
  return (
    <Sheet title="All operations" shape="side" onClose={onClose}>
      <Field label="Find" value={sought} onChange={setSought} first />
      <ul className="operation-list">
        {found.map((entry) => (
          <li key={entry.name}>
            <button type="button" className="list-row" onClick={() => onChoose(entry.name)}>
              <b>{titleOf(entry)}</b>
              <span>{drawingWords(entry.doc)}</span>
            </button>
          </li>
        ))}
      </ul>
    </Sheet>
  );
}
