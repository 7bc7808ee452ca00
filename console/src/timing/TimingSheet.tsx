import { useState } from "react";
import { useSnapshot } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { Opened } from "../wire/messages";
import { TimingChart } from "./TimingChart";
import { type Reading, useTiming } from "./useTiming";
import "./timing.css";

/** Inputs and outputs of the open file beside its motion, over time. */
export function TimingSheet({ onClose }: { onClose: () => void }) {
  const opened = useSnapshot("opened");
  const key = opened?.preview.state === "ready" ? opened.preview.key : undefined;
  const [inputs, setInputs] = useState("");
  const reading = useTiming(key, inputs);
  const words = wordsFor(opened, reading);
  const title = opened ? `Timing of ${opened.name}` : "Timing";
  return (
    <Sheet title={title} shape="wide" onClose={onClose}>
      {words !== undefined && (
        <p className="timing-words" role="status">
          {words}
        </p>
      )}
      {words === undefined && reading.state === "ready" && (
        <TimingChart key={`${key} ${inputs}`} timing={reading.timing} />
      )}
      {key !== undefined && <InputsForm onInputs={setInputs} />}
    </Sheet>
  );
}

/** What the inputs of the simulated machine do meanwhile. */
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

/** What is said where there is no chart. */
function wordsFor(opened: Opened | null | undefined, reading: Reading): string | undefined {
  if (!opened) return "Choose a file to see its timing.";
  if (opened.kind === "drawing") return "A drawing has no tool path yet, and so no timing.";
  if (opened.preview.state === "failed") return opened.preview.why;
  if (opened.preview.state === "working") return "Its preview is being made…";
  if (reading.state === "failed") return reading.why;
  if (reading.state === "reading") return "It runs on the simulated machine…";
  return reading.timing.lines.length === 0
    ? "Nothing moves in this file, and nothing is switched."
    : undefined;
}
