import { useEffect, useRef, useState } from "react";
import { ask, leased } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useDisplay } from "../app/display";
import { lengthOf } from "../app/expression";
import { shortText } from "../app/units";
import { KeyHelp } from "../ui/KeyHelp";
import { Sheet } from "../ui/Sheet";
import { inches, mm } from "../units/quantity";
import type { Speeds } from "../wire/messages";
import { t } from "../words/words";
import { JogButtons } from "./JogButtons";
import { JogManner, type Manner } from "./JogManner";
import "./keypad.css";
import { type Direction, directions, keyHelp, type Way, wayOfKey } from "./keys";
import { Pendant } from "./Pendant";
import { Recorded } from "./Recorded";
import { recorded } from "./record";
import { useJog } from "./useJog";
import { useMayMove } from "./useMayMove";

/** Words for other devices that move the tool, too (VD, keypad remote). */
const otherHands: Record<number, string> = {
  1: t("The keys of a pendant on the inputs move the tool, too."),
  2: t("Another program moves the tool, too, once it has taken control."),
};

/** The keypad (SK): moves the tool for as long as a key or button is held. */
interface KeypadSheetProps {
  /** Words of the part file that opened it. */
  words?: string;
  onClose: () => void;
}

export function KeypadSheet({ words, onClose }: KeypadSheetProps) {
  const hands = useHands();
  const jog = useJog();
  const motion = useSnapshot("motion");
  const units = useSnapshot("units");
  const speeds = useSnapshot("speeds");
  const [manner, setManner] = useState<Manner>("hold");
  const display = useDisplay();
  const fixed = display?.fixedMm;
  const others = display && otherHands[display.remote];
  const [typed, setTyped] = useState<{ text: string; linear: string } | null>(null);
  const unit = units ?? inches;
  // What was typed in another unit is another distance.
  const given = typed?.linear === unit.linear ? typed.text : undefined;
  const step = given ?? shortText(fixed ?? mm(2.54), unit);
  const [places, setPlaces] = useState<readonly string[] | null>(null);
  const [pendant, setPendant] = useState(false);
  const may = useMayMove();
  const onlySteps = may.onlySteps && manner === "hold";

  const move = (direction: Direction, fast: boolean) => {
    if (may.refused || onlySteps || !speeds || !units) return;
    const distance = manner === "distance" ? (lengthOf(step, units) ?? mm(0)) : null;
    const speedShare = fast ? 1 : slowShare(speeds, direction);
    jog.hold({ direction, speedShare, distance });
  };
  const begin = (way: Way, fast: boolean) => move(directions[way], fast);
  const keep = (axes: number) => {
    if (!motion || !units) return;
    const line = recorded(axes, motion, units.axes);
    setPlaces((now) => [...(now ?? []), line]);
    void ask(worldOf(hands), { do: "record", line });
  };
  const letter = (key: string): boolean => {
    if (key.toLowerCase() === "d") setManner(manner === "hold" ? "distance" : "hold");
    else if (key.toLowerCase() === "e") setPendant((now) => !now);
    else if (key === "#") setPlaces((now) => now ?? []);
    else if (places && /^[2-5]$/.test(key)) keep(Number(key));
    else return false;
    return true;
  };
  useJogKeys(begin, () => jog.release(), letter);
  useEffect(() => void leased(worldOf(hands)), [hands]);

  return (
    <Sheet title="Keypad" shape="side" onClose={onClose}>
      <div className="keypad">
        {words && <p className="keypad-words">{words}</p>}
        {others && <p className="keypad-words">{others}</p>}
        {may.refused && (
          <p className="keypad-refused" role="alert">
            {may.refused}
          </p>
        )}
        {onlySteps && (
          <p className="keypad-refused" role="alert">
            {t("The link is slow: only fixed distances move.")}
          </p>
        )}
        {units && (
          <JogManner
            units={units}
            manner={manner}
            step={step}
            onChange={(manner, step) => {
              setManner(manner);
              setTyped({ text: step, linear: unit.linear });
            }}
          />
        )}
        <JogButtons
          isDisabled={may.refused !== undefined || onlySteps}
          onHold={begin}
          onRelease={() => jog.release()}
        />
        {pendant && (
          <Pendant
            isDisabled={may.refused !== undefined || onlySteps}
            onHold={move}
            onRelease={() => jog.release()}
          />
        )}
        <Recorded places={places} onChange={setPlaces} onKeep={keep} />
        <KeyHelp keys={keyHelp} look="keypad-help" />
      </div>
    </Sheet>
  );
}

/** The share of the jog speed at which cuts are made: what moves without Ctrl. */
function slowShare({ cutMmS, jogMmS }: Speeds, direction: Direction): number {
  // X and Y share a speed; Z, A, B, C have their own.
  const first = direction.findIndex((way) => way !== 0);
  const group = Math.max(first - 1, 0);
  return Math.min(1, (cutMmS[group] ?? 1) / (jogMmS[group] ?? 1));
}

/** Keys that are held. Letting any of them go, Ctrl and Alt too, lets go of the handle. */
function useJogKeys(
  begin: (way: Way, fast: boolean) => void,
  release: () => void,
  letter: (key: string) => boolean,
) {
  const latest = useRef({ begin, release, letter });
  latest.current = { begin, release, letter };
  useEffect(() => {
    const down = (event: KeyboardEvent) => {
      if (event.target instanceof HTMLInputElement) return;
      const way = wayOfKey(event.key, event.altKey);
      if (!way && !latest.current.letter(event.key)) return;
      event.preventDefault();
      event.stopPropagation();
      if (way && !event.repeat) latest.current.begin(way, event.ctrlKey);
    };
    const up = () => latest.current.release();
    addEventListener("keydown", down, true);
    addEventListener("keyup", up, true);
    return () => {
      removeEventListener("keydown", down, true);
      removeEventListener("keyup", up, true);
    };
  }, []);
}
