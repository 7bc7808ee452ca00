import { arm, takeControl } from "../actions/machine";
import { useShown } from "../app/context";
import type { Shown } from "../link/shown";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";
import "./goes-on.css";

/** Right or state that this page lacks for an answer after which the machine goes on. */
export type Lacks = "control" | "arming";

/** An answer after which the machine goes on counts from whoever drives it, armed unless what runs is only drawn. */
export function lacks({ snapshot, who }: Shown): Lacks | undefined {
  const { lease, machine, job } = snapshot ?? {};
  if (lease && lease.client !== who?.client) return "control";
  return lease && (machine?.armed || job?.drawsOnly) ? undefined : "arming";
}

const words: Record<Lacks, string> = {
  control: t("Another page drives. To go on from here, take control and arm the machine."),
  arming: t("To go on, arm the machine."),
};

/** Says what has to be done before the machine goes on, and does it. Values, No and Quit do without. */
export function GoesOn() {
  const lacking = useShown(lacks);
  if (!lacking) return null;
  return (
    <p className="goes-on" role="note">
      <span>{words[lacking]}</span>
      <ActionButton action={lacking === "control" ? takeControl : arm} size="small" />
    </p>
  );
}
