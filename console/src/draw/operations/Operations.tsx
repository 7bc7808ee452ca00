import { useFetched } from "../../app/useFetched";
import type { OperationEntry } from "../../wire/messages";
import { OperationList } from "./OperationList";
import { OperationSheet } from "./OperationSheet";

interface OperationsProps {
  /** The operation whose sheet is open; blank is the list of all. */
  open: string | null;
  onOpen: (name: string | null) => void;
}

/** Sheets of operations, made from the server's table. */
export function Operations({ open, onOpen }: OperationsProps) {
  const table = useOperations(open !== null);
  if (open === null || table.length === 0) return null;
  const entry = table.find(({ name }) => name === open);
  const close = () => onOpen(null);
  return entry ? (
    <OperationSheet key={entry.name} entry={entry} onClose={close} />
  ) : (
    <OperationList table={table} onChoose={onOpen} onClose={close} />
  );
}

const none: readonly OperationEntry[] = [];

/** The table, read when it is wanted first. */
function useOperations(wanted: boolean): readonly OperationEntry[] {
  return useFetched(wanted ? "/api/drawing/operations" : null, none);
}
