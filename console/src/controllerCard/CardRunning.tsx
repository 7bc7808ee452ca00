import { hold, resume, stop } from "../actions/machine";
import { useSnapshot } from "../app/context";
import { useWords } from "../app/useWords";
import { FeedOverride } from "../operator/FeedOverride";
import { ActionButton } from "../ui/ActionButton";
import type { CurrentRun } from "../wire/messages";
import { t } from "../words/words";
import { runText } from "./card";

/** A file that the controller runs from its card: how far it is, and what holds and ends it. */
export function CardRunning({ job }: { job: CurrentRun }) {
  const words = useWords();
  const motion = useSnapshot("motion");
  const machine = useSnapshot("machine");
  if (!motion || !machine) return null;
  const held = machine.state === "held";
  return (
    <section aria-label={t("{0} runs from the card", job.file)}>
      <h3>{held ? t("{0} is held", job.file) : t("{0} runs from the card", job.file)}</h3>
      <progress
        className="controller-card-progress"
        value={motion.progress}
        max={1}
        aria-label={t("Progress of the file")}
      />
      <p role="status">{runText(job, motion)}</p>
      {machine.why !== null && <p role="note">{words(machine.why)}</p>}
      <FeedOverride />
      <div className="controller-card-acts">
        <ActionButton action={held ? resume : hold} look={held ? "go" : "hold"} />
        <ActionButton action={stop} look="hold">
          {t("End the file: STOP")}
        </ActionButton>
      </div>
      <p className="controller-card-words">
        {t("STOP slows it down, ends the file with the spindle off and lifts the tool.")}
      </p>
    </section>
  );
}
