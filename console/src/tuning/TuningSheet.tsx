import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import { Square } from "./Square";
import { Steps } from "./Steps";
import "./tuning.css";

/** Has the machine make true lengths and right angles: what was measured becomes what is set. */
export function TuningSheet({ onClose }: { onClose: () => void }) {
  return (
    <Sheet title={t("Steps and squareness")} shape="side" onClose={onClose}>
      <Steps />
      <Square />
    </Sheet>
  );
}
