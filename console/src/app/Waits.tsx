import { Button } from "../ui/Button";
import { useHands, useShown } from "./context";

/** Says what this page waits for, and lets it be given up. */
export function Waits() {
  const { link } = useHands();
  const waitsFor = useShown((shown) => shown.waitsFor);
  if (waitsFor === null) return null;
  return (
    <div className="notice card" role="status">
      <p className="notice-words">{waitsFor}</p>
      <Button size="small" onPress={() => void link.ask({ do: "giveUp" })}>
        Give up
      </Button>
    </div>
  );
}
