import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { machine } from "./actions";

/** The place of a job while none is open: a drawing has no tool path yet. */
export function NoJob() {
  const hands = useHands();
  const opened = useSnapshot("opened");
  const drawing = useSnapshot("drawing");
  if (opened?.kind === "drawing") {
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
  const drawn = (drawing?.shapes ?? 0) > 0;
  return (
    <div className="job-none">
      <p>
        {t(
          "A job is the tool path of a drawing: the machine cuts it with its own heights, speeds and sequence.",
        )}
      </p>
      {drawn && (
        <Button look="primary" onPress={() => void machine(worldOf(hands), null)}>
          Machine the drawing on the sheet
        </Button>
      )}
    </div>
  );
}
