import { type FormEvent, useState } from "react";
import type { World } from "../actions/action";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { numberText } from "../app/units";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import { isMetric, type Mm, ofUnit, shown } from "../units/quantity";
import type { Digitized, Units } from "../wire/messages";
import { t } from "../words/words";
import {
  begin,
  type DigitizingKey,
  dimensions,
  edits,
  exit,
  kind,
  looks,
  moveTo,
  press,
  record,
  shapes,
  steps,
} from "./keys";
import "./digitize.css";

/** Digitizing without a hand console: its screen, its keys by their names, the points. */
export function DigitizePanel() {
  const hands = useHands();
  const digitized = useSnapshot("digitized");
  const lines = useSnapshot("handConsole")?.lines ?? ["", ""];
  const units = useSnapshot("units");
  const only = useSnapshot("drawingOnly");
  if (only || !units) return null;
  const world = worldOf(hands);
  if (!digitized) {
    const isJob = lines[0].startsWith("JOB:");
    return (
      <Panel title="Digitize" aside={<Keys world={world} keys={[begin]} />}>
        {isJob || (
          <div className="digitize-body">
            <Screen lines={lines} />
          </div>
        )}
      </Panel>
    );
  }
  const { threeD, unsaved } = digitized;
  const kinds = threeD ? [dimensions.flat] : [kind, dimensions.space];
  return (
    <Panel
      title="Digitize"
      aside={unsaved ? <span className="digitize-new">{t("not saved")}</span> : null}
    >
      <div className="digitize-body">
        <Screen lines={lines} />
        <Keys world={world} keys={[record, ...kinds]} first />
        <Answers world={world} lines={lines} />
        <Points digitized={digitized} units={units} />
        <Keys world={world} keys={steps} />
        <Keys world={world} keys={edits} />
        <MoveTo world={world} units={units} />
        <Keys world={world} keys={looks} />
        <Keys world={world} keys={[...shapes, exit]} />
      </div>
    </Panel>
  );
}

function Screen({ lines }: { lines: readonly string[] }) {
  return (
    <output className="digitize-screen" aria-label={t("Screen of the hand console")}>
      {lines.map((line, n) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the lines are places
        <span key={n}>{line || " "}</span>
      ))}
    </output>
  );
}

interface KeysProps {
  world: World;
  keys: readonly DigitizingKey[];
  /** The first one is what is done most. */
  first?: boolean;
}

function Keys({ world, keys, first = false }: KeysProps) {
  return (
    <div className="digitize-keys">
      {keys.map((key, n) => (
        <span key={key.title} title={key.doc}>
          <Button
            size="small"
            look={first && n === 0 ? "primary" : "plain"}
            onPress={() => void press(world, key)}
          >
            {key.title}
          </Button>
        </span>
      ))}
    </div>
  );
}

const yes: DigitizingKey = { title: t("Yes"), doc: t("Enter"), keys: "E" };
const no: DigitizingKey = { title: t("No"), doc: t("Func"), keys: "U" };

/** Asks if the points may be lost. */
function Answers({ world, lines }: { world: World; lines: readonly string[] }) {
  if (!lines[0]?.startsWith("Lose ")) return null;
  return <Keys world={world} keys={[yes, no]} />;
}

function Points({ digitized, units }: { digitized: Digitized; units: Units }) {
  const { points, current, threeD } = digitized;
  if (points.length === 0) return <p className="digitize-words">{t("No points yet.")}</p>;
  const text = (length: Mm) => numberText(length, units, isMetric(units) ? 2 : 4);
  return (
    <div className="digitize-points">
      <table>
        <thead>
          <tr>
            <th>{t("Point")}</th>
            <th>X</th>
            <th>Y</th>
            {threeD && <th>Z</th>}
          </tr>
        </thead>
        <tbody>
          {points.map(({ at: [x, y, z], arc }, n) => (
            <tr
              // biome-ignore lint/suspicious/noArrayIndexKey: a point is its place in the list
              key={n}
              aria-current={n + 1 === current || undefined}
            >
              <th scope="row">
                {n + 1} {arc ? t("arc") : t("line")}
              </th>
              <td>{text(x)}</td>
              <td>{text(y)}</td>
              {threeD && <td>{text(z)}</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** A place that is typed, from the job origin. */
function MoveTo({ world, units }: { world: World; units: Units }) {
  const [place, setPlace] = useState({ x: "", y: "" });
  const numbers = [place.x, place.y].map((text) => Number(text.replace(",", ".")));
  const [x = Number.NaN, y = Number.NaN] = numbers;
  const ready = place.x !== "" && place.y !== "" && numbers.every(Number.isFinite);
  const go = (event: FormEvent) => {
    event.preventDefault();
    if (ready) void press(world, moveTo(ofUnit(shown(x), units), ofUnit(shown(y), units)));
  };
  const entry = (axis: "x" | "y") => (
    <input
      aria-label={t("Move to {0}, {1} from the job origin", axis.toUpperCase(), units.linear)}
      placeholder={axis.toUpperCase()}
      inputMode="decimal"
      value={place[axis]}
      onChange={(event) => setPlace({ ...place, [axis]: event.target.value })}
    />
  );
  return (
    <form className="digitize-move" onSubmit={go}>
      {entry("x")}
      {entry("y")}
      <span>{units.linear}</span>
      <Button size="small" type="submit" refused={ready ? undefined : t("Enter X and Y first.")}>
        Move to
      </Button>
    </form>
  );
}
