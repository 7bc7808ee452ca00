import { ask } from "../actions/ask";
import { EditorBar } from "../editor/EditorBar";
import { PausedDialog } from "../job/PausedDialog";
import { KeypadSheet } from "../keypad/KeypadSheet";
import { QuestionDialog } from "../operator/QuestionDialog";
import { StoppedDialog } from "../operator/StoppedDialog";
import { WaitingDialog } from "../operator/WaitingDialog";
import type { Asked } from "../wire/messages";
import { t } from "../words/words";
import { useHands, worldOf } from "./context";

/** The question of a job in its own shape. */
export function Asking({ asked }: { asked: Asked }) {
  const hands = useHands();
  const usual = asked.buttons[asked.default] ?? t("OK");
  const answer = () =>
    void ask(worldOf(hands), { do: "answer", question: asked.number, answer: usual });
  switch (asked.kind) {
    // It has a bar of its own, which stays between two lines.
    case "step":
      return null;
    case "keypad":
      return <KeypadSheet words={asked.text} onClose={answer} />;
    case "editor":
      return <EditorBar key={asked.number} asked={asked} />;
    case "hold":
      return <StoppedDialog key={asked.number} asked={asked} />;
    case "pause":
    case "msgbox":
      return <WaitingDialog key={asked.number} asked={asked} />;
    case "paused":
      // What is said to it changes the question, not the dialog.
      return <PausedDialog asked={asked} />;
    default:
      return <QuestionDialog key={asked.number} asked={asked} />;
  }
}

/** Tells whether a question takes the screen behind it away. */
export const covers = ({ kind }: Asked): boolean => kind !== "step" && kind !== "editor";
