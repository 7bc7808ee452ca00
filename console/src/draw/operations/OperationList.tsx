import { useState } from "react";
import { Field } from "../../ui/Field";
import { Sheet } from "../../ui/Sheet";
import type { OperationEntry } from "../../wire/messages";
import { operationDoc, operationTitle } from "../../words/operations";

interface OperationListProps {
  table: readonly OperationEntry[];
  onChoose: (name: string) => void;
  onClose: () => void;
}

/** Every operation of the table. */
export function OperationList({ table, onChoose, onClose }: OperationListProps) {
  const [sought, setSought] = useState("");
  const word = sought.trim().toLowerCase();
  const found = table.filter((entry) =>
    `${operationTitle(entry)} ${entry.name} ${operationDoc(entry)}`.toLowerCase().includes(word),
  );
  return (
    <Sheet title="All operations" shape="side" onClose={onClose}>
      <Field label="Find" value={sought} onChange={setSought} first />
      <ul className="operation-list">
        {found.map((entry) => (
          <li key={entry.name}>
            <button type="button" className="list-row" onClick={() => onChoose(entry.name)}>
              <b>{operationTitle(entry)}</b>
              <span>{operationDoc(entry)}</span>
            </button>
          </li>
        ))}
      </ul>
    </Sheet>
  );
}
