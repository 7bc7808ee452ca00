import { useEffect, useState } from "react";
import { deleted } from "../actions/files";
import { aboutFile } from "../actions/replace";
import { useHands, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { FileAbout } from "../wire/messages";
import { t } from "../words/words";
import { aboutText } from "./fileWords";

interface DeleteFileProps {
  name: string;
  onDone: () => void;
}

/** Asks before a file goes into the bin, and says what it is. */
export function DeleteFile({ name, onDone }: DeleteFileProps) {
  const hands = useHands();
  const [about, setAbout] = useState<FileAbout | null>(null);
  useEffect(() => {
    aboutFile(name).then(setAbout, (error: Error) => hands.screen.tell(error.message));
  }, [name, hands]);
  const erase = async () => {
    if (about && (await deleted(worldOf(hands), about))) onDone();
  };
  return (
    <Sheet
      title={t("Delete {0}?", name)}
      shape="question"
      onClose={onDone}
      foot={
        <>
          <Button size="large" data-first onPress={onDone}>
            Cancel
          </Button>
          <Button
            size="large"
            look="primary"
            refused={about ? undefined : t("It is being looked at.")}
            onPress={() => void erase()}
          >
            Delete
          </Button>
        </>
      }
    >
      <p className="question-text">
        {t(
          "{0}. It goes into the bin, from where it can be brought back.",
          about ? `${name}: ${aboutText(about)}` : name,
        )}
      </p>
    </Sheet>
  );
}
