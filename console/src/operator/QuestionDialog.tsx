import { type ReactNode, useState } from "react";
import { ask } from "../actions/ask";
import { useHands, worldOf } from "../app/context";
import { useAsked } from "../app/useWords";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { Asked } from "../wire/messages";
import { buttonWords } from "../words/asked";
import { t } from "../words/words";
import { GoesOn } from "./GoesOn";
import "./question-dialog.css";

const icons: Record<number, string> = { 16: "✖", 32: "?", 48: "!", 64: "i" };

/**
 * A question of the job. It belongs to the job and not to this page: any page may answer, and the
 * dialog closes on all of them when the server says so.
 */
export function QuestionDialog({ asked: told, more }: { asked: Asked; more?: ReactNode }) {
  const asked = useAsked(told);
  const [entry, setEntry] = useState(asked.prefill);
  const hands = useHands();
  const answer = (given: string) =>
    void ask(worldOf(hands), { do: "answer", question: asked.number, answer: given });
  const cancel = asked.buttons.find((word) => word.toLowerCase() === "cancel");
  return (
    <Sheet
      title={titleOf(asked)}
      shape="question"
      {...(cancel ? { onClose: () => answer(cancel) } : {})}
      foot={
        <>
          {more}
          <Answers asked={asked} entry={entry} answer={answer} />
        </>
      }
    >
      <form
        className="question"
        onSubmit={(event) => {
          event.preventDefault();
          answer(asked.entry ? entry : (asked.buttons[asked.default] ?? ""));
        }}
      >
        {icons[asked.icon] && (
          <span className={`question-icon question-icon-${asked.icon}`} aria-hidden="true">
            {icons[asked.icon]}
          </span>
        )}
        <p className="question-text">{asked.text}</p>
        {asked.entry && <Field label="Answer" value={entry} onChange={setEntry} first />}
      </form>
      {!asked.entry && <GoesOn />}
      <p className="question-place">{asked.file && t("{0}, line {1}", asked.file, asked.line)}</p>
    </Sheet>
  );
}

/** A title that is the path of the file is told by its name. */
const titleOf = ({ title, file }: Asked): string =>
  file !== "" && title.endsWith(file) ? file : title || t("The program asks");

interface AnswersProps {
  asked: Asked;
  entry: string;
  answer: (words: string) => void;
}

/** The buttons of the question; a question without any has OK. */
function Answers({ asked, entry, answer }: AnswersProps) {
  const words = asked.buttons.length > 0 ? asked.buttons : ["OK"];
  return words.map((word, n) => (
    <Button
      key={word}
      size="large"
      look={n === asked.default ? "primary" : "plain"}
      autoFocus={n === asked.default && !asked.entry}
      onPress={() => answer(asked.entry && n === asked.default ? entry : word)}
    >
      {buttonWords(word)}
    </Button>
  ));
}
