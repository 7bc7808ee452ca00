import type { State } from "../wire/messages";
import { useShown } from "./context";
import "./state-word.css";
import { useWords } from "./useWords";

const words: Record<State, string> = {
  idle: "Idle",
  running: "Running",
  jogging: "Jogging",
  held: "Held",
  asking: "Waiting for an answer",
  stopped: "Stopped",
  alarm: "Alarm",
};

/** What stands open is no question to everybody. */
const openWords: Record<string, string> = {
  keypad: "Keypad",
  step: "Line by line",
  editor: "Editor",
};

/** What the machine is doing, and why it does not move. */
export function StateWord() {
  const status = useShown((shown) => shown.status);
  const machine = useShown((shown) => shown.snapshot?.machine);
  const asked = useShown((shown) => shown.snapshot?.asked?.kind);
  if (status !== "open" || !machine) return <Word tone="lost" word="No link" />;
  const { state, armed, why } = machine;
  const open = state === "asking" && asked ? openWords[asked] : undefined;
  if (open) return <Word tone="asking" word={open} why={why} />;
  const word = state === "idle" ? (armed ? "Ready" : "Disarmed") : words[state];
  return <Word tone={state === "idle" && !armed ? "disarmed" : state} word={word} why={why} />;
}

function Word({ tone, word, why }: { tone: string; word: string; why?: string | null }) {
  const words = useWords();
  return (
    <div className={`state state-${tone}`} role="status">
      <span className="state-dot" aria-hidden="true" />
      <strong>{word}</strong>
      {why && <span className="state-why">{words(why)}</span>}
    </div>
  );
}
