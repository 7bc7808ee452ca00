import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";

interface DropChangesProps {
  name: string;
  onDrop: () => void;
  onClose: () => void;
}

/** Asks before text is dropped that was typed and not saved. */
export function DropChanges({ name, onDrop, onClose }: DropChangesProps) {
  return (
    <Sheet
      title={t("Drop the changes of {0}?", name)}
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
      <p className="question-text">{t("What was typed since it was saved is lost.")}</p>
    </Sheet>
  );
}
