import { asking } from "../actions/action";
import { start, takeUp } from "../actions/job";
import { acknowledge } from "../actions/machine";
import { useHands, useShown, useSnapshot } from "../app/context";
import { durationText } from "../app/units";
import { useWords } from "../app/useWords";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";
import { FeedOverride } from "./FeedOverride";
import { errorsOf, fileStatus, progressOf } from "./fileStatus";
import { MachineOverrides } from "./MachineOverrides";
import "./job-bar.css";

/** Shows the progress of the job and its time, with the buttons that start it. */
export function JobBar() {
  return (
    <section className="job panel" aria-label={t("Job")}>
      <Interrupted />
      <Progress />
      <FeedOverride />
      <StartButtons />
      <MachineOverrides />
    </section>
  );
}

const asksToTakeUp = asking(takeUp);

/** The run that can be taken up, while nothing else is going on. */
function Interrupted() {
  const words = useWords();
  const interrupted = useSnapshot("interrupted");
  const idle = useShown((shown) => shown.snapshot?.machine.state === "idle");
  if (!interrupted || !idle) return null;
  return (
    <p className="job-interrupted">
      <span>{words(interrupted.text)}</span>
      <ActionButton action={asksToTakeUp} size="small">
        Recover job…
      </ActionButton>
    </p>
  );
}

function Progress() {
  const snapshot = useShown((shown) => shown.snapshot);
  if (!snapshot) return null;
  const { name, part, words, seconds, spent } = progressOf(snapshot);
  return (
    <div className="job-progress">
      <p className="job-name">
        <strong>{name}</strong>
        <Status />
      </p>
      <progress value={part ?? 0} max={1} aria-label={t("Progress")} />
      <p className="job-times">
        <span>
          <b>{part === undefined ? "–" : Math.floor(part * 100)}</b> %
        </span>
        {spent !== undefined && <span className="job-spent">{spent}</span>}
        <span>
          {t(words)}{" "}
          <b className="job-left">{seconds === undefined ? "–" : durationText(seconds)}</b>
        </span>
      </p>
    </div>
  );
}

/** Shows the status of the open file; where it has mistakes, a way to them. */
function Status() {
  const { screen } = useHands();
  const snapshot = useShown((shown) => shown.snapshot);
  if (!snapshot) return null;
  const { words, look, place } = fileStatus(snapshot);
  const name = `job-status job-status-${look}`;
  return place ? (
    <button type="button" className={name} onClick={() => screen.showLine(place)}>
      {words}
    </button>
  ) : (
    <span className={name}>{words}</span>
  );
}

/** One after the other in the same place: acknowledge, then start. Green only where nothing was found. */
function StartButtons() {
  const alarm = useShown((shown) => shown.snapshot?.machine.state === "alarm");
  const opened = useSnapshot("opened");
  const doubtful = opened ? errorsOf(opened).length > 0 : false;
  return alarm ? (
    <ActionButton action={acknowledge} look="hold" size="large" className="job-start">
      Acknowledge
    </ActionButton>
  ) : (
    <ActionButton
      action={start}
      look={doubtful ? "hold" : "go"}
      size="large"
      className="job-start"
    />
  );
}
