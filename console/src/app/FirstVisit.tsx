import { useEffect } from "react";
import { isNewMachine } from "../settings/setUp";
import { useHands, useShown, useSnapshot } from "./context";

/** Leads whoever comes first to a new machine through its settings. */
export function FirstVisit() {
  const { screen } = useHands();
  const role = useShown((shown) => (shown.status === "open" ? shown.who?.role : undefined));
  const isBusy = useShown(({ snapshot }) => snapshot?.asked != null || snapshot?.job != null);
  const drawingOnly = useSnapshot("drawingOnly") ?? true;
  const start = useSnapshot("start");
  const may = (role === "setter" || role === "owner") && !drawingOnly && !isBusy && !start?.sheet;
  useEffect(() => {
    if (!may) return;
    isNewMachine().then(
      (isNew) => isNew && screen.get().sheet === null && screen.open({ kind: "setup" }),
      (error: Error) => screen.tell(error.message),
    );
  }, [may, screen]);
  return null;
}
