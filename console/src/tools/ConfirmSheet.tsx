import { attempt } from "../actions/action";
import { actions } from "../actions/registry";
import { useHands, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";

/** Asks before something that cannot be taken back, as a zero that is set in the wrong place. */
export function ConfirmSheet({ action: id, onClose }: { action: string; onClose: () => void }) {
  const hands = useHands();
  const action = actions.find((one) => one.id === id);
  if (!action) return null;
  return (
    <Sheet
      title={`${action.title}?`}
      shape="question"
      onClose={onClose}
      foot={
        <>
          <Button size="large" onPress={onClose}>
            Cancel
          </Button>
          <Button
            size="large"
            look="primary"
            autoFocus
            onPress={() => {
              attempt(action, worldOf(hands));
              onClose();
            }}
          >
            {action.title}
          </Button>
        </>
      }
    >
      <p className="question-text">{action.warns?.(worldOf(hands))}</p>
    </Sheet>
  );
}
