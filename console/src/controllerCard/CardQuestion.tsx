import { unlessReady } from "../actions/machine";
import { useHands, useShown, useSnapshot } from "../app/context";
import { durationText } from "../app/units";
import { useWords } from "../app/useWords";
import { Button } from "../ui/Button";
import type { CardAct, ControllerCard } from "../wire/messages";
import { t } from "../words/words";

/** Something that a person is asked about before it is done. */
export interface Question {
  readonly to: "run" | "delete";
  readonly name: string;
}

interface CardQuestionProps {
  card: ControllerCard;
  question: Question;
  refused: string | undefined;
  asks: (task: CardAct) => void;
  onClose: () => void;
}

/** Asks before a file is run or deleted. */
export function CardQuestion(props: CardQuestionProps) {
  const { question, refused, asks, onClose } = props;
  if (question.to === "run") return <RunQuestion {...props} />;
  const { name } = question;
  const doDelete = () => {
    onClose();
    asks({ to: "delete", name });
  };
  return (
    <section className="controller-card-question" aria-label={t("Delete {0}?", name)}>
      <h3>{t("Delete {0}?", name)}</h3>
      <p>{t("It is taken off the card, and is in no bin.")}</p>
      <div className="controller-card-acts">
        <Button refused={refused} look="primary" onPress={doDelete}>
          Delete it
        </Button>
        <Button onPress={onClose}>Leave it there</Button>
      </div>
    </section>
  );
}

/** Asks whether everything is ready, once the file was looked through. */
function RunQuestion({ card, question: { name }, ...props }: CardQuestionProps) {
  const { asks, onClose } = props;
  const words = useWords();
  const { link, screen } = useHands();
  const unready = useShown((shown) => unlessReady({ shown, link, screen }));
  const refused = props.refused ?? unready;
  const machine = useSnapshot("machine")?.name ?? "";
  const zero = (useSnapshot("zeros") ?? []).find(
    ({ name, holds }) => holds && name.startsWith("G5"),
  );
  const looked = card.files?.find((file) => file.name === name)?.looked;
  const unread = card.unread === name;
  if (!looked && !unread) return null;
  const run = () => {
    onClose();
    asks({ to: "run", name, unseen: !looked });
  };
  return (
    <section className="controller-card-question" aria-label={t("Run {0}?", name)}>
      <h3>{t("Run {0}?", name)}</h3>
      <p>
        {t(
          "{0} runs it from its card by itself, from where it stands, at its zero point {1}. STOP slows it down, ends the file with the spindle off and lifts the tool; the file is not taken up again there.",
          machine,
          zero?.name ?? "G54",
        )}
      </p>
      {looked ? (
        <p>{t("It takes about {0}, as estimated.", durationText(looked.seconds))}</p>
      ) : (
        <p role="alert">
          {t("Its text cannot be read back: nobody has checked it, and its time is unknown.")}
        </p>
      )}
      {looked?.warnings.map((warning) => (
        <p key={warning} role="note">
          {words(warning)}
        </p>
      ))}
      <p>{t("The material is fixed, the right tool is in, and everybody is clear of it?")}</p>
      <div className="controller-card-acts">
        <Button refused={refused} look={looked ? "go" : "hold"} onPress={run}>
          {looked ? t("Run it") : t("Run it unchecked")}
        </Button>
        <Button onPress={onClose}>Do not run it</Button>
      </div>
    </section>
  );
}
