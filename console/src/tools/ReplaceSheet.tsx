import { fileAddress } from "../link/http";
import { FileText } from "../operator/FileText";
import { aboutText } from "../operator/fileWords";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { FileAbout } from "../wire/messages";

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
      title={`Replace ${about.name}?`}
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
        {about.name} is there already: {aboutText(about)}. It is replaced as a whole; the last 20
        versions of it are kept.
      </p>
      <FileText address={fileAddress(about.name)} label="What is replaced" />
    </Sheet>
  );
}
