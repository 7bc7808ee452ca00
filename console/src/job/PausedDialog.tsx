import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { lengthText, placeText } from "../app/units";
import { useAsked, useWords } from "../app/useWords";
import { GoesOn } from "../operator/GoesOn";
import { useAside } from "../operator/useAside";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Sheet } from "../ui/Sheet";
import { mm } from "../units/quantity";
import type { Asked } from "../wire/messages";
import { buttonWords } from "../words/asked";
import { phrase, t } from "../words/words";
import { headAt, near } from "./head";
import { useJob } from "./useJob";
import { lengthField, speedField, ValueField } from "./ValueField";
import "./job-screen.css";

/**
 * A job that waits: before its start, at a pause mark, or because something stopped it. The tool can be
 * moved, speeds and ZBottom changed; cutting goes on at the very place.
 */
export function PausedDialog({ asked }: { asked: Asked }) {
  const hands = useHands();
  const { sheet, buttons } = useAside(["keypad", "inputs"]);
  const say = (words: string) =>
    ask(worldOf(hands), { do: "answer", question: asked.number, answer: words });
  const told = useAsked(asked);
  if (sheet) return sheet;
  const chooses = asked.text.startsWith("Start with shape");
  const [goesOn = "Resume", ends = "Quit"] = asked.buttons;
  return (
    <Sheet
      title={told.text || told.title}
      shape="side"
      foot={
        <>
          <Button size="large" onPress={() => void say(ends)}>
            {buttonWords(ends)}
          </Button>
          <Button size="large" look="go" autoFocus onPress={() => void say(goesOn)}>
            {chooses ? t("Start") : buttonWords(goesOn)}
          </Button>
        </>
      }
    >
      <div className="paused">
        <div className="paused-hands">{buttons}</div>
        <Forbidden />
        <GoesOn />
        {chooses ? <ChooseStart text={asked.text} say={say} /> : <ChangeValues say={say} />}
      </div>
    </Sheet>
  );
}

/** The mend that is needed before anything moves again. */
function Forbidden() {
  const forbidden = useSnapshot("io")?.forbidden;
  const words = useWords();
  return forbidden ? (
    <p className="paused-forbidden" role="alert">
      {t("Nothing moves: {0}.", words(forbidden))}
    </p>
  ) : null;
}

interface Says {
  say: (words: string) => Promise<boolean>;
}

/** The path with which the job begins, before its second Start. */
function ChooseStart({ text, say }: Says & { text: string }) {
  const number = Number(/\d+/.exec(text)?.[0] ?? 1);
  return (
    <>
      <HeadWords number={number} />
      <div className="start-choice">
        <ValueField
          label={t("Begins with path")}
          value={number}
          onSet={(value) => say(String(Math.max(1, Math.round(value))))}
        />
        <Button aria-label="The path before" onPress={() => void say("previous")}>
          −
        </Button>
        <Button aria-label="The next path" onPress={() => void say("next")}>
          +
        </Button>
      </div>
    </>
  );
}

/** The place of the head, and the way from there to the path. */
function HeadWords({ number }: { number: number }) {
  const plan = useJob();
  const units = useSnapshot("units");
  const motion = useSnapshot("motion");
  if (!plan || !units || !motion) return null;
  const [x, y, z] = motion.at.machine;
  const head = headAt(plan.view, number, [x, y]);
  if (!head) return null;
  const height = `Z ${lengthText(z, units)}`;
  const there = t("the beginning of path {0}", number);
  if (head.awayMm < near)
    return <p>{t("The head stands over {0}, {1}. Start cuts from there.", there, height)}</p>;
  return (
    <p>
      {t(
        "The head stands at {0}, {1}: {2} from {3}. Start takes it there first, at Z home.",
        placeText(head.at, units),
        height,
        lengthText(head.awayMm, units),
        there,
      )}
    </p>
  );
}

/** Speeds and heights of the rest of the job. */
function ChangeValues({ say }: Says) {
  const plan = useJob();
  const units = useSnapshot("units");
  const job = useSnapshot("job");
  if (!plan || !units) return null;
  const heights = job?.heights;
  // What was said holds until the job is over; the configuration stays as it was.
  const { cutMmS, plungeMmS, raise } = job?.inForce ?? plan.view;
  return (
    <>
      <p>
        {t(
          "The tool goes back to where the cut was left by itself, however far it is moved. What is changed here holds for the rest of the job.",
        )}
      </p>
      <div className="cut-grid">
        <ValueField
          {...speedField(t("Cutting speed"), cutMmS, units, (speed) => say(`cut ${speed}`))}
        />
        <ValueField
          {...speedField(t("Plunging speed"), plungeMmS, units, (speed) => say(`plunge ${speed}`))}
        />
        <ValueField
          {...lengthField(t("Move Z bottom by"), mm(0), units, async (way) => {
            await say(`zbottom ${way}`);
            // What was asked for is done: the field is ready for the next change.
            return false;
          })}
        />
        <div className="field">
          <span className="field-label">{t("Rises when paused")}</span>
          <Choice
            label="Rises when paused"
            options={[
              { value: "yes", words: "Yes" },
              { value: "no", words: "No" },
            ]}
            value={raise ? "yes" : "no"}
            onChange={(value) => void say(`raise ${value}`)}
          />
        </div>
      </div>
      {heights && (
        <p className="paused-heights">
          {phrase(
            "Z top {0}, surface {1}, bottom {2}",
            lengthText(heights[0], units),
            lengthText(heights[1], units),
            <b>{lengthText(heights[2], units)}</b>,
          )}
        </p>
      )}
    </>
  );
}
