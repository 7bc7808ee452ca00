import type { Asked, Machine, State } from "../wire/messages";
import { t } from "../words/words";
import { useShown } from "./context";
import "./state-word.css";
import { useWords } from "./useWords";

const words: Record<State, string> = {
  idle: "Idle",
  running: t("Running"),
  jogging: t("Jogging"),
  held: t("Held"),
  asking: t("Waiting for an answer"),
  stopped: t("Stopped"),
  alarm: t("Alarm"),
};

/** Words for dialogs that stand open without a question to everybody. */
const openWords: Record<string, string> = {
  keypad: t("Keypad"),
  step: t("Line by line"),
  editor: t("Editor"),
};

/** Shows the state of the machine, and why it does not move. */
export function StateWord() {
  const status = useShown((shown) => shown.status);
  const machine = useShown((shown) => shown.snapshot?.machine);
  const asked = useShown((shown) => shown.snapshot?.asked);
  const forbidden = useShown((shown) => shown.snapshot?.io.forbidden);
  if (status !== "open" || !machine) return <Word tone="lost" word={t("No link")} />;
  const { tone, word } = wordOf(machine, asked, Boolean(forbidden));
  return <Word tone={tone} word={word} why={word === pressed ? forbidden : machine.why} />;
}

/** The words of a strip on which a pressed stop forbids motion. */
const pressed = t("Stop pressed");

/** The word for what the machine is doing, and its tone. */
function wordOf({ state, armed }: Machine, asked: Asked | null | undefined, forbidden: boolean) {
  if (forbidden && (state === "idle" || state === "stopped"))
    return { tone: "alarm", word: pressed };
  const open = state === "asking" && asked ? openWords[asked.kind] : undefined;
  if (open) return { tone: "asking", word: open };
  // A job that waits was not stopped for good: it goes on when it is told to.
  if (state === "stopped" && asked?.kind === "paused") return { tone: "held", word: t("Paused") };
  if (state === "idle" && !armed) return { tone: "disarmed", word: t("Disarmed") };
  return { tone: state, word: state === "idle" ? t("Ready") : words[state] };
}

interface WordProps {
  tone: string;
  word: string;
  why?: string | null | undefined;
}

function Word({ tone, word, why }: WordProps) {
  const words = useWords();
  return (
    <div className={`state state-${tone}`} role="status">
      <span className="state-dot" aria-hidden="true" />
      <strong>{t(word)}</strong>
      {why && <span className="state-why">{words(why)}</span>}
    </div>
  );
}
