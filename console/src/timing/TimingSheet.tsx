import { useState } from "react";
import { useSnapshot } from "../app/context";
import { useWords } from "../app/useWords";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { Opened, Timing } from "../wire/messages";
import { t } from "../words/words";
import { TimingChart } from "./TimingChart";
import { type Reading, timingOf, useTiming } from "./useTiming";
import { endWords } from "./words";
import "./timing.css";

/** Inputs and outputs of the open file beside its motion, over time. */
export function TimingSheet({ onClose }: { onClose: () => void }) {
  const opened = useSnapshot("opened");
  const key = opened?.preview.state === "ready" ? opened.preview.key : undefined;
  const [inputs, setInputs] = useState("");
  const reading = useTiming(opened?.name, key, inputs);
  const timing = timingOf(reading);
  const busy = reading.state === "reading";
  const said = useWords();
  const words = wordsFor(opened, reading, timing);
  const title = opened ? t("Timing of {0}", opened.name) : t("Timing");
  return (
    <Sheet title={title} about="Timing chart" shape="wide" onClose={onClose}>
      {words !== undefined && (
        <p className="timing-words" role="status">
          {said(words)}
        </p>
      )}
      {words === undefined && timing && (
        <TimingChart key={opened?.name} timing={timing} busy={busy} />
      )}
      {key !== undefined && <InputsForm onInputs={setInputs} />}
    </Sheet>
  );
}

/** Form for the inputs of the simulated machine during the run. */
function InputsForm({ onInputs }: { onInputs: (inputs: string) => void }) {
  const [text, setText] = useState("");
  return (
    <form
      className="timing-inputs"
      onSubmit={(event) => {
        event.preventDefault();
        onInputs(text.trim());
      }}
    >
      <Field
        label="Inputs"
        value={text}
        onChange={setText}
        hint="Input at a time in seconds, 1 on, 0 off: 3@2.5=1, arc@4=1"
      />
      <Button type="submit" size="small">
        Show
      </Button>
    </form>
  );
}

/** Words in place of a missing chart. */
function wordsFor(
  opened: Opened | null | undefined,
  reading: Reading,
  timing: Timing | undefined,
): string | undefined {
  if (!opened) return t("Choose a file to see its timing.");
  if (opened.kind === "drawing") return t("A drawing has no tool path yet, and so no timing.");
  if (opened.preview.state === "failed") return opened.preview.why;
  if (reading.state === "failed") return reading.why;
  if (timing) return timing.lines.length === 0 ? nothingWords(timing) : undefined;
  const made = opened.preview.state === "ready";
  return made ? t("It runs on the simulated machine…") : t("Its preview is being made…");
}

const nothingWords = (timing: Timing): string =>
  endWords(timing) ?? t("Nothing moves in this file, and nothing is switched.");
