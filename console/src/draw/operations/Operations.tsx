import { useEffect, useState } from "react";
import { useHands } from "../../app/context";
import { getJson } from "../../link/http";
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

/** The table, read when it is wanted first. */
function useOperations(wanted: boolean): readonly OperationEntry[] {
  const { screen } = useHands();
  const [table, setTable] = useState<readonly OperationEntry[]>([]);
  const missing = wanted && table.length === 0;
  useEffect(() => {
    if (!missing) return;
    const gone = new AbortController();
    getJson<OperationEntry[]>("/api/drawing/operations", gone.signal)
      .then(setTable)
      .catch((error: Error) => gone.signal.aborted || screen.tell(error.message));
    return () => gone.abort();
  }, [missing, screen]);
  return table;
}
