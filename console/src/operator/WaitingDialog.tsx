import { drive } from "../actions/ask";
import { useHands, useShown, worldOf } from "../app/context";
import { refusal } from "../keypad/refusal";
import { Button } from "../ui/Button";
import type { Asked } from "../wire/messages";
import { QuestionDialog } from "./QuestionDialog";
import { useAside } from "./useAside";

/**
 * The question of a program that waits, with its tool perhaps in the cut: to change a tool or to turn the part
 * it can be lifted and moved away. Where the program goes on, it goes back by itself.
 */
export function WaitingDialog({ asked }: { asked: Asked }) {
  const hands = useHands();
  const { sheet, buttons } = useAside(["keypad", "inputs"]);
  const refused = useShown(refusal);
  const lift = () => void drive(worldOf(hands), { do: "lift", question: asked.number });
  const more = (
    <span className="question-more">
      <Button onPress={lift}>Lift the tool</Button>
      {buttons}
    </span>
  );
  return sheet ?? <QuestionDialog asked={asked} {...(refused === undefined ? { more } : {})} />;
}
