import { type PointerEvent, useEffect, useRef } from "react";
import { ask, leased } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useJog } from "../keypad/useJog";
import { leaseOf } from "../link/shown";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import "./hand-console.css";
import { type ConsoleKey, keyOf, pad } from "./keys";

/**
 * The hand console of the machine: its screen, and its keys with the mouse and on the keyboard. It lies over
 * whatever is open, as a console in the hand would; the strip with STOP stays free.
 */
export function HandConsole() {
  const hands = useHands();
  const shown = useSnapshot("handConsole");
  const jog = useJog();
  const held = useRef<ConsoleKey>(undefined);
  /** Takes the machine first; a key that is let go before that means nothing. */
  const takeAndPress = async (key: ConsoleKey) => {
    const lease = await leased(worldOf(hands));
    if (lease !== undefined && held.current === key) jog.press(key.key);
  };
  const press = (key: ConsoleKey) => {
    held.current = key;
    const world = worldOf(hands);
    const isStop = key.key === "P";
    if (leaseOf(world.shown) !== undefined) jog.press(key.key);
    else if (isStop) void ask(world, { do: "key", lease: 0, seq: 0, key: key.key });
    else void takeAndPress(key);
  };
  const release = () => {
    held.current = undefined;
    jog.release();
  };
  useKeyboard(press, release);
  useEffect(() => void leased(worldOf(hands)), [hands]);
  const down = (key: ConsoleKey) => (event: PointerEvent) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    press(key);
  };
  return (
    <aside className="hand-console" aria-label={t("Hand console")}>
      <div className="hand-console-head">
        <h2>{t("Hand console")}</h2>
        <Button
          look="quiet"
          size="small"
          onPress={() => hands.screen.showHandConsole(false)}
          aria-label="Put the hand console away"
        >
          ✕
        </Button>
      </div>
      <output className="hand-console-screen" aria-label={t("Screen of the hand console")}>
        {(shown?.lines ?? ["", ""]).map((line, row) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: the two lines never change places
          <span key={row}>{line.padEnd(20)}</span>
        ))}
      </output>
      <fieldset className="hand-console-keys" aria-label={t("Keys of the hand console")}>
        {pad.map((key) => (
          <button
            key={key.key}
            type="button"
            className={`hand-console-key hand-console-key-${key.label.toLowerCase()}`}
            aria-label={key.name ?? key.label}
            onPointerDown={down(key)}
            onPointerUp={release}
            onPointerCancel={release}
            onLostPointerCapture={release}
            onContextMenu={(event) => event.preventDefault()}
          >
            {key.label}
          </button>
        ))}
      </fieldset>
      {shown?.link && <p className="hand-console-link">{shown.link}</p>}
    </aside>
  );
}

const isField = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement &&
  (target.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(target.tagName));

/** Its keys on the keyboard, before anything else that these mean. */
function useKeyboard(press: (key: ConsoleKey) => void, release: () => void) {
  const latest = useRef({ press, release });
  latest.current = { press, release };
  useEffect(() => {
    const meant = (event: KeyboardEvent) => {
      const key = keyOf(event.code, isField(event.target));
      if (!key || event.ctrlKey || event.altKey || event.metaKey) return undefined;
      event.preventDefault();
      event.stopPropagation();
      return key;
    };
    const down = (event: KeyboardEvent) => {
      const key = meant(event);
      if (key && !event.repeat) latest.current.press(key);
    };
    const up = (event: KeyboardEvent) => meant(event) && latest.current.release();
    addEventListener("keydown", down, true);
    addEventListener("keyup", up, true);
    return () => {
      removeEventListener("keydown", down, true);
      removeEventListener("keyup", up, true);
    };
  }, []);
}
