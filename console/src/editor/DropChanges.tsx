import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";

interface DropChangesProps {
  name: string;
  onDrop: () => void;
  onClose: () => void;
}

/** Asks before text is dropped that was typed and not saved. */
export function DropChanges({ name, onDrop, onClose }: DropChangesProps) {
  return (
    <Sheet
      title={`Drop the changes of ${name}?`}
      shape="question"
      onClose={onClose}
      foot={
        <>
          <Button size="large" data-first onPress={onClose}>
            Cancel
          </Button>
          <Button
            size="large"
            look="primary"
            onPress={() => {
              onDrop();
              onClose();
            }}
          >
            Drop changes
          </Button>
        </>
      }
    >
      <p className="question-text">What was typed since it was saved is lost.</p>
    </Sheet>
  );
}
