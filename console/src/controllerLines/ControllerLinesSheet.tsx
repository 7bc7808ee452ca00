import { useState } from "react";
import type { TextFieldProps } from "react-aria-components";
import { drive } from "../actions/ask";
import { useHands, worldOf } from "../app/context";
import { downloadText } from "../link/download";
import { getText } from "../link/http";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { Tail } from "../ui/Tail";
import type { ControllerLine } from "../wire/messages";
import { serverWords } from "../words/server";
import { t } from "../words/words";
import { shownOf, timeOf, type Way } from "./lines";
import { useLines } from "./useLines";
import "./controller-lines.css";

const ways: readonly { value: Way; words: string }[] = [
  { value: "all", words: "Both ways" },
  { value: "sent", words: "Sent" },
  { value: "came", words: "Answered" },
  { value: "errors", words: "Errors" },
];

const wordsOf = ({ words }: ControllerLine) => serverWords(words);

/** Shows the lines that are sent to the controller and its answers as they pass, and sends a line that is typed. */
export function ControllerLinesSheet({ onClose }: { onClose: () => void }) {
  const { screen } = useHands();
  const [routine, setRoutine] = useState(false);
  const [paused, setPaused] = useState(false);
  const [way, setWay] = useState<Way>("all");
  const [search, setSearch] = useState("");
  const { lines, gone, refusal } = useLines(routine, paused);
  const shown = shownOf(lines, way, search, wordsOf);
  const save = () =>
    getText("/api/lines/text").then(
      (text) => downloadText("controller-lines.txt", text),
      (error: Error) => screen.tell(error.message),
    );
  if (refusal && lines.length === 0) {
    return (
      <Sheet title={t("Console of the controller")} shape="wide" onClose={onClose}>
        <p role="status">{serverWords(refusal)}</p>
      </Sheet>
    );
  }
  return (
    <Sheet title={t("Console of the controller")} shape="wide" onClose={onClose}>
      <div className="controller-lines-choices">
        <Choice label="Lines that are shown" options={ways} value={way} onChange={setWay} />
        <label>
          <input
            type="checkbox"
            checked={routine}
            onChange={(event) => setRoutine(event.target.checked)}
          />{" "}
          {t("Status reports and ok")}
        </label>
        <Button aria-pressed={paused} onPress={() => setPaused(!paused)}>
          {paused ? "Go on" : "Pause"}
        </Button>
        <Button onPress={() => void save()}>Save to a file</Button>
      </div>
      <Field label="Find" placeholder="text of a line" value={search} onChange={setSearch} />
      {gone > 0 && <p className="controller-lines-gone">{t("{0} older lines are gone.", gone)}</p>}
      <div className="controller-lines">
        <Tail
          label={t("Sent and answered")}
          empty={t("Nothing is found.")}
          count={shown.at(-1)?.number ?? 0}
        >
          {shown.map((line) => (
            <Row key={line.number} line={line} />
          ))}
        </Tail>
      </div>
      <Typed />
    </Sheet>
  );
}

/** The mark of the way that a line went. */
const markOf = ({ kind, sent }: ControllerLine) => (kind === "link" ? "•" : sent ? "→" : "←");

/** The same for whoever hears it. */
const saidOf = ({ kind, sent }: ControllerLine) =>
  kind === "link" ? t("Connection") : sent ? t("Sent") : t("Answered");

function Row({ line }: { line: ControllerLine }) {
  const words = wordsOf(line);
  return (
    <p className="controller-line" data-kind={line.kind}>
      <time>{timeOf(line)}</time> <span aria-hidden="true">{markOf(line)}</span>{" "}
      <span className="hidden-text">{saidOf(line)}</span> <code>{line.text}</code>{" "}
      {words && <em>{words}</em>}
    </p>
  );
}

/** A line that is typed: of OpenSBP or G-code, a setting of the controller or a question for it. */
function Typed() {
  const hands = useHands();
  const [text, setText] = useState("");
  const send = async () => {
    if (text.trim() === "") return;
    if (await drive(worldOf(hands), { do: "command", line: text.trim() })) setText("");
  };
  const press: TextFieldProps["onKeyDown"] = (event) => {
    if (event.key === "Enter") void send();
    // Escape closes the sheet.
    else event.continuePropagation();
  };
  return (
    <div className="controller-lines-typed">
      <Field
        label="Line"
        placeholder="$I asks the controller, $120=500 sets it, MX,2 moves"
        value={text}
        onChange={setText}
        onKeyDown={press}
        first
      />
      <Button look="primary" onPress={() => void send()}>
        Send
      </Button>
    </div>
  );
}
