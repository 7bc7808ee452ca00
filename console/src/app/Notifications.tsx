import { useEffect, useRef } from "react";
import type { Snapshot } from "../wire/messages";
import { useShown } from "./context";
import { newsOf, notifies } from "./notify";

/** Notifies whoever looks at something else when the machine needs somebody, and when a run is over. */
export function Notifications() {
  const job = useShown(({ snapshot }) => snapshot?.job);
  const asked = useShown(({ snapshot }) => snapshot?.asked);
  const before = useRef<Pick<Snapshot, "job" | "asked">>(undefined);
  useEffect(() => {
    if (job === undefined || asked === undefined) return;
    const now = { job, asked };
    const text = before.current && newsOf(before.current, now);
    before.current = now;
    if (text && notifies() && !document.hasFocus()) new Notification("Kerf", { body: text });
  }, [job, asked]);
  return null;
}
