import { Button } from "../ui/Button";
import { useHands, useScreen } from "./context";
import { useWords } from "./useWords";
import { Waits } from "./Waits";
import "./notices.css";

/** Shows the last refusals with their reasons. */
export function Notices() {
  const { screen } = useHands();
  const notices = useScreen("notices");
  const words = useWords();
  return (
    <div className="notices" role="status" aria-live="polite">
      <Waits />
      {notices.map(({ id, text }) => (
        <div className="notice card" key={id}>
          <p className="notice-words">{words(text)}</p>
          <Button look="quiet" size="small" onPress={() => screen.dismiss(id)}>
            Dismiss
          </Button>
        </div>
      ))}
    </div>
  );
}
