import { fileAddress } from "../link/http";
import { FileText } from "../operator/FileText";
import { aboutText } from "../operator/fileWords";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { FileAbout } from "../wire/messages";
import { t } from "../words/words";

interface ReplaceSheetProps {
  about: FileAbout;
  onAnswer: (mayBeReplaced: boolean) => void;
  onClose: () => void;
}

/** Asks before a file is replaced, and says what would be lost. */
export function ReplaceSheet({ about, onAnswer, onClose }: ReplaceSheetProps) {
  const answer = (mayBeReplaced: boolean) => {
    onAnswer(mayBeReplaced);
    onClose();
  };
  return (
    <Sheet
      title={t("Replace {0}?", about.name)}
      shape="question"
      onClose={() => answer(false)}
      foot={
        <>
          <Button size="large" data-first onPress={() => answer(false)}>
            Cancel
          </Button>
          <Button size="large" look="primary" onPress={() => answer(true)}>
            Replace
          </Button>
        </>
      }
    >
      <p className="question-text">
        {t(
          "{0} is there already: {1}. It is replaced as a whole; the last 20 versions of it are kept.",
          about.name,
          aboutText(about),
        )}
      </p>
      <FileText address={fileAddress(about.name)} label={t("What is replaced")} />
    </Sheet>
  );
}
