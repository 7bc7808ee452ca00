import { asking } from "../actions/action";
import { start, takeUp } from "../actions/job";
import { acknowledge } from "../actions/machine";
import { useShown, useSnapshot } from "../app/context";
import { durationText } from "../app/units";
import { ActionButton } from "../ui/ActionButton";
import { FeedOverride } from "./FeedOverride";
import "./job-bar.css";

/** How far the job is, how long it takes, and what starts it. */
export function JobBar() {
  return (
    <section className="job panel" aria-label="Job">
      <Interrupted />
      <Progress />
      <FeedOverride />
      <StartButtons />
    </section>
  );
}

const asksToTakeUp = asking(takeUp);

/** The run that can be taken up, while nothing else is going on. */
function Interrupted() {
  const interrupted = useSnapshot("interrupted");
  const idle = useShown((shown) => shown.snapshot?.machine.state === "idle");
  if (!interrupted || !idle) return null;
  return (
    <p className="job-interrupted">
      <span>{interrupted.text}</span>
      <ActionButton action={asksToTakeUp} size="small">
        Take it up…
      </ActionButton>
    </p>
  );
}

function Progress() {
  const motion = useSnapshot("motion");
  const opened = useSnapshot("opened");
  const job = useSnapshot("job");
  const runs = job !== null && job !== undefined && job.ended === null;
  const part = runs ? (motion?.progress ?? 0) : job?.ended === "ok" ? 1 : 0;
  const left = runs ? (motion?.remaining ?? 0) : (opened?.seconds ?? 0);
  return (
    <div className="job-progress">
      <p className="job-name">
        <strong>{opened?.name ?? job?.command ?? "No file open"}</strong>
        <span>{outcome(job?.ended)}</span>
      </p>
      <progress value={part} max={1} aria-label="Progress" />
      <p className="job-times">
        <span>
          <b>{Math.floor(part * 100)}</b> %
        </span>
        <span>
          {runs ? "left " : "planned "}
          <b className="job-left">{durationText(left)}</b>
        </span>
      </p>
    </div>
  );
}

const outcomes: Record<string, string> = {
  ok: "finished",
  ended: "ended by itself",
  failed: "failed",
  stopped: "stopped",
  limit: "ended at a limit",
};

const outcome = (ended: string | null | undefined): string =>
  ended ? (outcomes[ended] ?? ended) : "";

/** One after the other in the same place: acknowledge, then start. */
function StartButtons() {
  const alarm = useShown((shown) => shown.snapshot?.machine.state === "alarm");
  return alarm ? (
    <ActionButton action={acknowledge} look="hold" size="large" className="job-start">
      Acknowledge
    </ActionButton>
  ) : (
    <ActionButton action={start} look="go" size="large" className="job-start" />
  );
}
