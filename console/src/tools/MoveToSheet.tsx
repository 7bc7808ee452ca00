import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { evaluate } from "../app/expression";
import { usedAxes } from "../app/units";
import { useBusy } from "../app/useBusy";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { ofAxisUnit, shownOnAxis } from "../units/quantity";
import type { AxisUnits, ByHand, Units } from "../wire/messages";
import { t } from "../words/words";
import { cutMove, isWrong, type Made, moveTo } from "./moveTo";
import "./tools.css";

const from = [
  { value: "origin", words: "Job origin" },
  { value: "here", words: "Here" },
] as const;

const ways = [
  { value: "3d", words: "3D: all together" },
  { value: "2d", words: "2D: X and Y, then the others" },
] as const;

const cuts = [
  { value: "no", words: "No" },
  { value: "yes", words: "Yes" },
] as const;

/** Moves the tool to places that are given in numbers, and home (Profiler: Changing the Tool Position). */
export function MoveToSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const units = useSnapshot("units");
  const busy = useBusy();
  const go = (way: ByHand) => void drive(worldOf(hands), { do: "go", way });
  if (!units) return null;
  const shared = { units, busy, go };
  return (
    <Sheet title="Move the tool to" shape="side" onClose={onClose}>
      <p className="tool-words">
        {t("X and Y count from the job origin, the other axes from home. STOP ends every move.")}
      </p>
      <MoveTo {...shared} />
      <CutMoveTo {...shared} />
      <Home {...shared} />
    </Sheet>
  );
}

interface WayProps {
  units: Units;
  busy: string | undefined;
  go: (way: ByHand) => void;
}

/** Numbers that are entered by axis. */
type Entries = Record<string, string>;

function useEntries(read: (entries: Entries) => Made, go: (way: ByHand) => void) {
  const [entries, setEntries] = useState<Entries>({});
  const [wrong, setWrong] = useState<string>();
  const enter = (letter: string, text: string) => setEntries({ ...entries, [letter]: text });
  const send = () => {
    const made = read(entries);
    setWrong(isWrong(made) ? made.wrong : undefined);
    if (!isWrong(made)) go(made);
  };
  return { entries, enter, wrong, send };
}

function MoveTo({ units, busy, go }: WayProps) {
  const [base, setBase] = useState<"origin" | "here">("origin");
  const [way, setWay] = useState<"2d" | "3d">("3d");
  const axes = usedAxes(units);
  const how = { relative: base === "here", flat: way === "2d" };
  const { entries, enter, wrong, send } = useEntries(
    (entries) => moveTo(axes, entries, number(units), how),
    go,
  );
  return (
    <section className="move-to" aria-label={t("MoveTo")}>
      <h3>{t("MoveTo")}</h3>
      <div className="move-to-axes">
        {axes.map(({ axis }, n) => (
          <AxisField
            key={axis.letter}
            {...{ axis, entries, enter }}
            placeholder={t("stays")}
            first={n === 0}
          />
        ))}
      </div>
      <Choice label="From" options={from} value={base} onChange={setBase} />
      <Choice label="Way" options={ways} value={way} onChange={setWay} />
      <Wrong text={wrong} />
      <Button look="primary" refused={busy} onPress={send}>
        Move
      </Button>
    </section>
  );
}

function CutMoveTo({ units, busy, go }: WayProps) {
  const [cut, setCut] = useState<"yes" | "no">("no");
  const axes = usedAxes(units).slice(0, 2);
  const { entries, enter, wrong, send } = useEntries(
    (entries) => cutMove(axes, entries, number(units), cut === "yes"),
    go,
  );
  return (
    <section className="move-to" aria-label={t("CutMoveTo")}>
      <h3>{t("CutMoveTo")}</h3>
      <div className="move-to-axes">
        {axes.map(({ axis }) => (
          <AxisField key={axis.letter} {...{ axis, entries, enter }} />
        ))}
      </div>
      <div className="move-to-cut">
        {t("Cuts on the way")}
        <Choice label="Cuts on the way" options={cuts} value={cut} onChange={setCut} />
      </div>
      <Wrong text={wrong} />
      <Button look={cut === "yes" ? "hold" : "primary"} refused={busy} onPress={send}>
        {cut === "yes" ? t("Cut there") : t("Move there")}
      </Button>
    </section>
  );
}

function Home({ units, busy, go }: WayProps) {
  const [left, setLeft] = useState<readonly string[]>([]);
  const letters = usedAxes(units).map(({ axis }) => axis.letter);
  const chosen = letters.filter((letter) => !left.includes(letter));
  const turn = (letter: string) =>
    setLeft(left.includes(letter) ? left.filter((one) => one !== letter) : [...left, letter]);
  return (
    <section className="move-to" aria-label={t("Move to home")}>
      <h3>{t("Move to home, Z first")}</h3>
      <div className="move-to-axes">
        {letters.map((letter) => (
          <label key={letter}>
            <input
              type="checkbox"
              checked={chosen.includes(letter)}
              onChange={() => turn(letter)}
            />
            {letter}
          </label>
        ))}
      </div>
      <Button
        look="primary"
        refused={busy ?? (chosen.length === 0 ? t("Choose an axis first.") : undefined)}
        onPress={() => go({ to: "home", axes: chosen.join("") })}
      >
        Move home
      </Button>
    </section>
  );
}

/** The meaning of a number that is entered for an axis. */
const number = (units: Units) => (text: string, axis: AxisUnits) => {
  const value = evaluate(text, units);
  return value === undefined ? undefined : ofAxisUnit(shownOnAxis(value), axis);
};

interface AxisFieldProps {
  axis: AxisUnits;
  entries: Entries;
  enter: (letter: string, text: string) => void;
  /** The meaning of an empty field. */
  placeholder?: string;
  first?: boolean;
}

function AxisField({ axis, entries, enter, placeholder = "", first = false }: AxisFieldProps) {
  const { letter, unit } = axis;
  return (
    <Field
      label={letter}
      unit={unit}
      value={entries[letter] ?? ""}
      onChange={(text) => enter(letter, text)}
      placeholder={placeholder}
      first={first}
    />
  );
}

function Wrong({ text }: { text: string | undefined }) {
  return text === undefined ? null : (
    <p className="move-to-wrong" role="alert">
      {text}
    </p>
  );
}
