import { useEffect, useState } from "react";
import { drive, ask as request } from "../actions/ask";
import { whenIdle } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { useWords } from "../app/useWords";
import { leaseOf } from "../link/shown";
import { isUnderWay } from "../operator/fileStatus";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { CardAct, ControllerCard } from "../wire/messages";
import { t } from "../words/words";
import { CardFiles } from "./CardFiles";
import { CardQuestion, type Question } from "./CardQuestion";
import { CardRunning } from "./CardRunning";
import { CardUpload } from "./CardUpload";
import { filesText, taskText } from "./card";
import "./controller-card.css";

/** The files that the controller keeps on a card of its own and runs by itself: listed, put there, run, followed. */
export function ControllerCardSheet({ onClose }: { onClose: () => void }) {
  const card = useSnapshot("controllerCard");
  if (!card) return null;
  return (
    <Sheet title={t("Card of the controller")} shape="side" onClose={onClose}>
      {card.has ? <Card card={card} onClose={onClose} /> : <NoCard why={card.why} />}
    </Sheet>
  );
}

function NoCard({ why }: { why: string }) {
  const words = useWords();
  return (
    <p role="status">
      {why === "" ? t("This machine has no controller with a card of its own.") : words(why)}
    </p>
  );
}

interface CardProps {
  card: ControllerCard;
  onClose: () => void;
}

function Card({ card, onClose }: CardProps) {
  const hands = useHands();
  const { link, screen } = hands;
  const busy = useShown((shown) => whenIdle({ shown, link, screen }));
  // Between two steps of a task the machine stands for a moment.
  const refused = card.task ? t("Something is done on the card.") : busy;
  const runs = useSnapshot("job") ?? null;
  const [question, setQuestion] = useState<Question>();
  const [last, setLast] = useState<CardAct>();
  const asks = (task: CardAct) => {
    setLast(task);
    void drive(worldOf(hands), { do: "controllerCard", task });
  };
  useListedOnce(card, () => asks({ to: "list" }));
  const ask = (next: Question) => {
    setQuestion(next);
    const file = card.files?.find(({ name }) => name === next.name);
    if (next.to === "run" && !file?.looked) asks({ to: "look", name: next.name });
  };
  if (isUnderWay(runs) && runs.fromCard) return <CardRunning job={runs} />;
  return (
    <>
      <p className="controller-card-words">
        {t(
          "The controller keeps these files itself and runs them without Kerf: a run goes on when the line is lost or Kerf ends.",
        )}
      </p>
      <CardUpload refused={refused} asks={asks} />
      <Told {...{ card, last, asks, onClose }} />
      {question && (
        <CardQuestion
          {...{ card, question, refused, asks }}
          onClose={() => setQuestion(undefined)}
        />
      )}
      <div className="controller-card-acts">
        <Button refused={refused} onPress={() => asks({ to: "list" })}>
          List the files
        </Button>
        {card.files && <span>{filesText(card.files)}</span>}
      </div>
      {card.files && <CardFiles files={card.files} {...{ refused, ask, asks }} />}
    </>
  );
}

/** Lists the files when the sheet opens on a page that drives a machine that stands. */
function useListedOnce(card: ControllerCard, list: () => void) {
  const { link } = useHands();
  const drives = leaseOf(link.shown.get()) !== undefined;
  const wants = drives && card.task === null && link.shown.get().snapshot?.machine.state === "idle";
  // biome-ignore lint/correctness/useExhaustiveDependencies: once, when it opens
  useEffect(() => {
    if (wants) list();
  }, []);
}

interface ToldProps {
  card: ControllerCard;
  last: CardAct | undefined;
  asks: (task: CardAct) => void;
  onClose: () => void;
}

/** Tells what is done on the card, and what became of it. */
function Told({ card, last, asks, onClose }: ToldProps) {
  const words = useWords();
  const { task, refused, replaces, kept, notes } = card;
  if (task) return <Doing {...{ task, asks }} />;
  return (
    <>
      {refused.length > 0 && (
        <ul className="controller-card-refused" role="alert">
          {refused.map((why) => (
            <li key={why}>{words(why)}</li>
          ))}
        </ul>
      )}
      {replaces !== null && last && "replaces" in last && (
        <div className="controller-card-acts">
          <Button look="primary" onPress={() => asks({ ...last, replaces: true })}>
            {t("Replace {0}", replaces)}
          </Button>
        </div>
      )}
      {notes.length > 0 && (
        <ul className="controller-card-notes" role="note">
          {notes.map((note) => (
            <li key={note}>{words(note)}</li>
          ))}
        </ul>
      )}
      {kept !== null && <Kept name={kept} onClose={onClose} />}
    </>
  );
}

function Doing({
  task,
  asks,
}: { task: NonNullable<ControllerCard["task"]> } & Pick<ToldProps, "asks">) {
  return (
    <div className="controller-card-acts" role="status">
      <span>{taskText(task)}</span>
      {task.all > 0 && (
        <progress value={task.done} max={task.all} aria-label={t("Progress of the task")} />
      )}
      {task.kind !== "run" && <Button onPress={() => asks({ to: "cancel" })}>Cancel</Button>}
    </div>
  );
}

/** A file was copied into the part folder, where its preview is made when it is opened. */
function Kept({ name, onClose }: { name: string; onClose: () => void }) {
  const hands = useHands();
  const open = async () => {
    if (await request(worldOf(hands), { do: "open", name })) onClose();
  };
  return (
    <div className="controller-card-acts" role="status">
      <span>{t("{0} is in the part folder.", name)}</span>
      <Button onPress={() => void open()}>Open it: its preview is made</Button>
    </div>
  );
}
