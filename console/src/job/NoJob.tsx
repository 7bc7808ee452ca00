import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { machine } from "./actions";

/** The place of a job while none is open: a drawing has no tool path yet. */
export function NoJob() {
  const hands = useHands();
  const opened = useSnapshot("opened");
  if (opened?.kind !== "drawing") return null;
  return (
    <div className="job-none">
      <p>
        <b>{opened.name}</b>{" "}
        {t("is a drawing: it has no tool path yet, and the machine cuts nothing of it.")}
      </p>
      <Button look="primary" onPress={() => void machine(worldOf(hands), opened.name)}>
        Make the tool path
      </Button>
    </div>
  );
}
