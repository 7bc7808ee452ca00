import { giveControl, takeControl } from "../actions/machine";
import { leaseOf } from "../link/shown";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";
import { useShown } from "./context";
import "./lease-chip.css";

/** Shows who drives, where there is more than one page; nobody needs to know otherwise. */
export function LeaseChip() {
  const lease = useShown((shown) => shown.snapshot?.lease);
  const drives = useShown((shown) => leaseOf(shown) !== undefined);
  const alone = useShown((shown) => (shown.snapshot?.clients.length ?? 0) < 2);
  if (!lease || (drives && alone)) return null;
  return (
    <div className="lease">
      <span>{drives ? t("You drive") : t("Driven by {0}", lease.device || t("another page"))}</span>
      <ActionButton action={drives ? giveControl : takeControl} size="small" />
    </div>
  );
}
