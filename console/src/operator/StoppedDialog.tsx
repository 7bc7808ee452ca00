import type { Asked } from "../wire/messages";
import { QuestionDialog } from "./QuestionDialog";
import { useAside } from "./useAside";

/**
 * The question after a stop in the middle of a job: on or not. Before that the tool can be moved away, to
 * look or to clean; the job goes back to its place by itself.
 */
export function StoppedDialog({ asked }: { asked: Asked }) {
  const { sheet, buttons } = useAside(["keypad", "nudge", "inputs"]);
  return (
    sheet ?? (
      <QuestionDialog asked={asked} more={<span className="question-more">{buttons}</span>} />
    )
  );
}
