import { useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useScreen, worldOf } from "../app/context";
import { GoesOn } from "../operator/GoesOn";
import { Button } from "../ui/Button";
import type { Asked } from "../wire/messages";
import "./step-bar.css";
import { useRunToBreakpoint } from "./useRunToBreakpoint";

/** What is done with the line that is due, while a file is gone through line by line (FG). */
export function StepBar({ asked }: { asked: Asked }) {
  const hands = useHands();
  const breakpoints = useScreen("breakpoints");
  const answer = (words: string) =>
    ask(worldOf(hands), { do: "answer", question: asked.number, answer: words });
  const run = useRunToBreakpoint(asked, breakpoints, () => answer("Step"));
  return (
    <section className="step" aria-label="Line by line" data-react-aria-top-layer="true">
      <p className="step-line">
        <span>Line {asked.line}</span>
        <code>{asked.text}</code>
      </p>
      <GoesOn />
      {run.runs ? (
        <Button look="hold" onPress={run.halt}>
          Halt
        </Button>
      ) : (
        <>
          <Button look="primary" onPress={() => void answer("Step")} autoFocus>
            Step
          </Button>
          <Button isDisabled={breakpoints.length === 0} onPress={run.begin}>
            To breakpoint
          </Button>
          <Button onPress={() => void answer("Run")}>Run on</Button>
          {asked.prefill && (
            <Button onPress={() => void answer(`${asked.prefill}`)}>Back to {asked.prefill}</Button>
          )}
          <GoToLine onGo={(words) => void answer(words)} />
          <Button onPress={() => void answer("Quit")}>Quit</Button>
        </>
      )}
    </section>
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
        <span className="hidden-text">Line to go to</span>
        <input
          inputMode="numeric"
          placeholder="Line"
          value={line}
          onChange={(event) => setLine(event.target.value)}
        />
      </label>
      <Button type="submit" isDisabled={!valid}>
        Go to
      </Button>
      <Button isDisabled={!valid} onPress={() => onGo(`${line.trim()} settings`)}>
        … with settings
      </Button>
    </form>
  );
}
