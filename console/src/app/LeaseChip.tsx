import { takeControl } from "../actions/machine";
import { ActionButton } from "../ui/ActionButton";
import { useShown } from "./context";
import "./lease-chip.css";

/** Who drives, when it is not this page; nobody needs to know otherwise. */
export function LeaseChip() {
  const lease = useShown((shown) => shown.snapshot?.lease);
  const client = useShown((shown) => shown.who?.client);
  if (!lease || lease.client === client) return null;
  return (
    <div className="lease">
      <span>Driven by {lease.device || "another page"}</span>
      <ActionButton action={takeControl} size="small" />
    </div>
  );
}
