import { useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { FileSheet } from "../draw/FileSheet";
import { busy } from "../keypad/refusal";
import { Button } from "../ui/Button";
import { drawingEndings } from "../wire/endings";
import { phrase, t } from "../words/words";

/** The name of the job, and another one. */
export function JobHead() {
  const hands = useHands();
  const opened = useSnapshot("opened");
  const idle = useShown((shown) => ["idle", "alarm"].includes(shown.snapshot?.machine.state ?? ""));
  const [asking, setAsking] = useState(false);
  const name = opened?.kind === "program" ? "" : (opened?.name ?? "");
  return (
    <header className="job-head">
      <p className="drawing-name">{name || t("No job is open")}</p>
      <Button size="small" refused={idle ? undefined : busy} onPress={() => setAsking(true)}>
        Open a job…
      </Button>
      <Added />
      {asking && (
        <FileSheet
          title={t("Open a job or a drawing")}
          endings={drawingEndings}
          onClose={() => setAsking(false)}
          onName={(name) => ask(worldOf(hands), { do: "open", name })}
        />
      )}
    </header>
  );
}

/** Shapes that were added to the job and are not in its file yet. */
function Added() {
  const hands = useHands();
  const added = useSnapshot("opened")?.added ?? 0;
  if (added === 0) return null;
  return (
    <p className="job-added">
      {phrase(
        "{0} not saved{1}{2}",
        added === 1 ? t("1 shape is") : t("{0} shapes are", added),
        <Button size="small" onPress={() => void ask(worldOf(hands), { do: "takeShapeBack" })}>
          Take the last back
        </Button>,
        <Button
          size="small"
          look="primary"
          onPress={() => void ask(worldOf(hands), { do: "saveJob" })}
        >
          Save the job
        </Button>,
      )}
    </p>
  );
}
