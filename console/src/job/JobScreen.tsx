import { useMemo, useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { DigitizePanel } from "../digitize/DigitizePanel";
import { FileSheet } from "../draw/FileSheet";
import { busy } from "../keypad/refusal";
import { JobBar } from "../operator/JobBar";
import { LocationDisplay } from "../operator/LocationDisplay";
import { Button } from "../ui/Button";
import { phrase, t } from "../words/words";
import { machine } from "./actions";
import { CutPanel } from "./CutPanel";
import { JobSheet } from "./JobSheet";
import { PathPanel } from "./PathPanel";
import { standingOf } from "./plan";
import { useJob } from "./useJob";
import "../draw/drawing-sheet.css";
import "./job-screen.css";

/** Files that lead to a job: jobs, and drawings that become one. */
const endings = ["rsm", "rsg", "dxf", "svg"];

/** The machine's side of a drawing: its tool paths, how they are cut, how far the job is. */
export function JobScreen() {
  const plan = useJob();
  const job = useSnapshot("job");
  const line = useShown((shown) => shown.snapshot?.motion.line ?? 0);
  const opened = useSnapshot("opened");
  const snapshot = useShown((shown) => shown.snapshot);
  // biome-ignore lint/correctness/useExhaustiveDependencies: only what a standing is made of
  const standing = useMemo(() => standingOf(snapshot, plan), [job, line, opened, plan]);
  return (
    <div className="job-screen">
      <h1 className="hidden-text">{t("Job")}</h1>
      <div className="job-page-left">
        <LocationDisplay />
        {plan && <CutPanel plan={plan} />}
      </div>
      <div className="job-page-middle">
        <JobHead />
        {plan ? <JobSheet plan={plan} standing={standing} /> : <NoJob />}
        <JobBar />
      </div>
      <div className="job-page-right">
        {plan && <PathPanel plan={plan} standing={standing} />}
        <DigitizePanel />
      </div>
    </div>
  );
}

/** The name of the job, and another one. */
function JobHead() {
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
          endings={endings}
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

/** Where no job is open: a drawing has no tool path yet. */
function NoJob() {
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
