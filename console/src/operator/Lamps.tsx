import { asking, attempt } from "../actions/action";
import { outputs } from "../actions/machine";
import { useHands, useScreen, useSnapshot, worldOf } from "../app/context";
import { Panel } from "../ui/Panel";
import type { Lamp } from "../wire/messages";
import { t } from "../words/words";
import "./lamps.css";

/** The inputs and outputs of the machine. */
export function Lamps() {
  const io = useSnapshot("io");
  if (!io) return null;
  return (
    <Panel title="Inputs and outputs" className="lamps">
      <Row title={t("In")} word="Input" lamps={io.inputs} />
      <Row title={t("Out")} word="Output" lamps={io.outputs} />
    </Panel>
  );
}

/** The sheet behind the word at the head of a row, and what it is for. */
const behind = {
  Input: { kind: "inputs", about: t("Move the switches of the machine") },
  Output: { kind: "ports", about: t("Every port of the card") },
} as const;

interface RowProps {
  title: string;
  word: keyof typeof behind;
  lamps: readonly Lamp[];
}

function Row({ title, word, lamps }: RowProps) {
  const { screen } = useHands();
  const moved = useSnapshot("machine")?.offers.inputs;
  const { kind, about } = behind[word];
  return (
    <div className="lamps-row">
      {word === "Output" || moved ? (
        <button
          type="button"
          className="lamps-press"
          title={about}
          onClick={() => screen.open({ kind })}
        >
          {title}
        </button>
      ) : (
        <h3>{title}</h3>
      )}
      <ol>
        {lamps.map((lamp) => (
          <li key={lamp.number} title={lamp.label || `${t(word)} ${lamp.number}`}>
            <LampLight lamp={lamp} word={word} />
          </li>
        ))}
      </ol>
    </div>
  );
}

/** Outputs from here on are switched at one press. */
const harmless = 3;

/** A light; that of an output is a switch in FULL. */
function LampLight({ lamp, word }: { lamp: Lamp; word: string }) {
  const hands = useHands();
  const full = useScreen("face") === "full";
  const action = word === "Output" ? outputs[lamp.number - 1] : undefined;
  const look = `lamp lamp-${word.toLowerCase()} lamp-${lamp.duty} ${lamp.on ? "lamp-on" : ""}`;
  const inside = (
    <>
      <span className="lamp-number" aria-hidden="true">
        {lamp.number}
      </span>
      <span className="hidden-text">
        {t(
          "{0} {1} {2} is {3}{4}",
          t(word),
          lamp.number,
          lamp.label,
          lamp.on ? t("on") : t("off"),
          duties[lamp.duty],
        )}
      </span>
    </>
  );
  if (!action || !full) return <div className={look}>{inside}</div>;
  const asked = lamp.number < harmless ? asking(action) : action;
  return (
    <button
      type="button"
      className={look}
      aria-pressed={lamp.on}
      onClick={() => attempt(asked, worldOf(hands))}
    >
      {inside}
    </button>
  );
}

const duties: Record<Lamp["duty"], string> = {
  standard: "",
  limit: t(", a limit switch"),
  stop: t(", stops the machine"),
};
