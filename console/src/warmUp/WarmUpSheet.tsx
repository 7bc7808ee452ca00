import { useState } from "react";
import { drive } from "../actions/ask";
import { stop, unlessReady } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { useFetched } from "../app/useFetched";
import { PauseCard } from "../operator/PauseCard";
import { useSettings } from "../settings/useSettings";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { RunRecord } from "../wire/messages";
import { t } from "../words/words";
import { allMinutes, changed, hoursSince, type Step, stepsOf, textOf } from "./steps";
import "./warm-up.css";

/** The setting that keeps the steps. */
const setting = "options.warm_up";

/** The name of the errand, as the machine tells it. */
const errand = "warm-up";

const noRuns: readonly RunRecord[] = [];

/** Warms the spindle up where the machine stands: steps of speed and time. */
export function WarmUpSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const kept = useKept();
  const [typed, setTyped] = useState<readonly Step[]>();
  const job = useSnapshot("job");
  const steps = typed ?? stepsOf(kept);
  const minutes = allMinutes(steps);
  const runs = job?.command === errand && !job.ended;
  const start = () =>
    void drive(worldOf(hands), { do: "go", way: { to: "warmUp", steps: textOf(steps) } });
  const keep = () => void drive(worldOf(hands), { do: "set", key: setting, value: textOf(steps) });
  return (
    <Sheet
      title={t("Spindle warm-up")}
      shape="side"
      onClose={onClose}
      foot={
        runs ? (
          <ActionButton action={stop} look="hold">
            {t("End the warm-up")}
          </ActionButton>
        ) : (
          <Button
            look="go"
            refused={minutes ? refused : t("Each step has a number of percent and minutes.")}
            onPress={start}
          >
            Start the warm-up
          </Button>
        )
      }
    >
      <p className="warm-up-words">
        {t(
          "The spindle turns where the machine stands, in these steps. STOP ends it with the spindle off. Nothing touches the tool, and everybody is clear of it?",
        )}
      </p>
      <LastRun />
      <ul className="warm-up-steps">
        {steps.map((step, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a step is known by its place
          <li key={at}>
            <Field
              label={t("Step {0}, speed", at + 1)}
              unit="%"
              value={step.percent}
              onChange={(percent) => setTyped(changed(steps, at, { percent }))}
            />
            <Field
              label={t("Step {0}, time", at + 1)}
              unit="min"
              value={step.minutes}
              onChange={(minutes) => setTyped(changed(steps, at, { minutes }))}
            />
            <Button
              size="small"
              aria-label={t("Take step {0} away", at + 1)}
              onPress={() => setTyped(steps.filter((_, n) => n !== at))}
            >
              ×
            </Button>
          </li>
        ))}
      </ul>
      <div className="warm-up-kept">
        <Button onPress={() => setTyped([...steps, { percent: "100", minutes: "2" }])}>
          Add a step
        </Button>
        <Button refused={textOf(steps) === kept ? t("They are kept.") : undefined} onPress={keep}>
          Keep these steps
        </Button>
      </div>
      {minutes !== undefined && <p role="status">{t("{0} min in all", minutes)}</p>}
      {runs && <PauseCard />}
    </Sheet>
  );
}

/** The steps that the settings keep. */
function useKept(): string {
  const entries = useSettings().flatMap(({ settings }) => settings);
  return entries.find(({ key }) => key === setting)?.value ?? "";
}

/** Tells how long nothing has run, where that is known. */
function LastRun() {
  const runs = useFetched("/api/history", noRuns);
  const hours = hoursSince(runs, Date.now() / 1000);
  if (hours === undefined) return null;
  return (
    <p className="warm-up-words">
      {hours === 0
        ? t("The last file ran less than an hour ago.")
        : t("The last file ran {0} h ago.", hours)}
    </p>
  );
}
