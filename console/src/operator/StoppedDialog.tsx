import { useState } from "react";
import { useShown } from "../app/context";
import { KeypadSheet } from "../keypad/KeypadSheet";
import { InputsSheet } from "../tools/InputsSheet";
import { NudgeSheet } from "../tools/NudgeSheet";
import { Button } from "../ui/Button";
import type { Asked } from "../wire/messages";
import { QuestionDialog } from "./QuestionDialog";

type Hand = "keypad" | "nudge" | "inputs";

/**
 * The question after a stop in the middle of a job: on or not. Before that the tool can be moved away, to
 * look or to clean; the job goes back to its place by itself.
 */
export function StoppedDialog({ asked }: { asked: Asked }) {
  const [hand, setHand] = useState<Hand | null>(null);
  // A switch that stopped the machine has to be let go; a real one is not on a screen.
  const simulated = useShown((shown) => shown.snapshot?.machine.mode !== "cut");
  const back = () => setHand(null);
  if (hand === "keypad") {
    return (
      <KeypadSheet
        words="The job stands. Where it goes on, the tool goes back by itself."
        onClose={back}
      />
    );
  }
  if (hand === "nudge") return <NudgeSheet onClose={back} />;
  if (hand === "inputs") return <InputsSheet onClose={back} />;
  return (
    <QuestionDialog
      asked={asked}
      more={
        <span className="question-more">
          <Button onPress={() => setHand("keypad")}>Move the tool…</Button>
          <Button onPress={() => setHand("nudge")}>Nudge…</Button>
          {simulated && <Button onPress={() => setHand("inputs")}>Inputs…</Button>}
        </span>
      }
    />
  );
}
