import { useState } from "react";
import { useScreen, useShown } from "../app/context";
import { GoesOn } from "../operator/GoesOn";
import { Button } from "../ui/Button";
import type { Asked } from "../wire/messages";
import { t } from "../words/words";
import "./step-bar.css";
import { useStepsOn } from "./useStepsOn";

/**
 * Buttons for the line that is due, while a file is gone through line by line (FG). They stay while this
 * page steps on by itself, also between two lines.
 */
export function StepBar() {
  const due = useShown(({ snapshot }) =>
    snapshot?.asked?.kind === "step" ? snapshot.asked : null,
  );
  const step = useStepsOn(due);
  if (!due && !step.runs) return null;
  return (
    <section className="step card" aria-label={t("Line by line")} data-react-aria-top-layer="true">
      <p className="step-line one-line">
        <span>{due ? t("Line {0}", due.line) : t("On to a breakpoint")}</span>
        <code>{due?.text}</code>
      </p>
      <GoesOn />
      {step.runs ? (
        <Button look="hold" onPress={step.halt}>
          Halt
        </Button>
      ) : (
        due && <Steps due={due} onAnswer={step.answer} onBegin={step.begin} />
      )}
    </section>
  );
}

interface StepsProps {
  due: Asked;
  onAnswer: (words: string) => void;
  onBegin: () => void;
}

function Steps({ due, onAnswer, onBegin }: StepsProps) {
  const breakpoints = useScreen("breakpoints");
  return (
    <>
      <Button look="primary" onPress={() => onAnswer("Step")} autoFocus>
        Step
      </Button>
      <Button
        refused={
          breakpoints.length === 0
            ? t("No line has a breakpoint: set one in the editor.")
            : undefined
        }
        onPress={onBegin}
      >
        To breakpoint
      </Button>
      <Button onPress={() => onAnswer("Run")}>Run on</Button>
      {due.prefill && (
        <Button onPress={() => onAnswer(`${due.prefill}`)}>{t("Back to {0}", due.prefill)}</Button>
      )}
      <GoToLine onGo={onAnswer} />
      <Button onPress={() => onAnswer("Quit")}>Quit</Button>
    </>
  );
}

/** Goes on at another line; what lies between may be prepared for. */
function GoToLine({ onGo }: { onGo: (words: string) => void }) {
  const [line, setLine] = useState("");
  const valid = /^[1-9]\d*$/.test(line.trim());
  return (
    <form
      className="step-goto"
      onSubmit={(event) => {
        event.preventDefault();
        if (valid) onGo(line.trim());
      }}
    >
      <label>
        <span className="hidden-text">{t("Line to go to")}</span>
        <input
          inputMode="numeric"
          placeholder={t("Line")}
          value={line}
          onChange={(event) => setLine(event.target.value)}
        />
      </label>
      <Button
        type="submit"
        refused={valid ? undefined : t("Enter the number of a line of the file.")}
      >
        Go to
      </Button>
      <Button
        refused={valid ? undefined : t("Enter the number of a line of the file.")}
        onPress={() => onGo(`${line.trim()} settings`)}
      >
        … with settings
      </Button>
    </form>
  );
}
