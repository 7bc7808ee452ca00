import { useState } from "react";
import { clearPrinted } from "../actions/job";
import { useHands, useSnapshot } from "../app/context";
import { drawingWords } from "../app/drawingWords";
import { useWords } from "../app/useWords";
import { ActionButton } from "../ui/ActionButton";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import { Tail } from "../ui/Tail";
import { findingWords, messageWords } from "../words/findings";
import { t } from "../words/words";
import { FindingPlace } from "./FindingPlace";
import { errorsOf, placeOf, placeOfMessage } from "./fileStatus";
import "./words-panel.css";

type Kind = "messages" | "printed" | "notes";

const kinds: readonly { value: Kind; words: string }[] = [
  { value: "messages", words: "Messages" },
  { value: "printed", words: "Print" },
  { value: "notes", words: "File" },
];

/** Shows the messages of the program and of the machine. */
export function WordsPanel() {
  // What keeps the file from running comes first, until somebody looks for something else.
  const opened = useSnapshot("opened");
  const [chosen, setChosen] = useState<{ kind: Kind; hash: string | undefined } | null>(null);
  const errors = opened ? errorsOf(opened).length > 0 : false;
  const own = chosen && (chosen.hash === opened?.hash || !errors);
  const kind = own ? chosen.kind : errors ? "notes" : "messages";
  const setKind = (kind: Kind) => setChosen({ kind, hash: opened?.hash });
  return (
    <Panel
      title="Words"
      className="words"
      aside={<Choice label="What is shown" options={kinds} value={kind} onChange={setKind} />}
    >
      {kind === "messages" && <Messages />}
      {kind === "printed" && <Printed />}
      {kind === "notes" && <FileNotes />}
    </Panel>
  );
}

function Messages() {
  const { screen } = useHands();
  const opened = useSnapshot("opened");
  const messages = useSnapshot("messages") ?? [];
  const words = useWords();
  return (
    <Tail label={t("Messages")} empty={t("Nothing to report.")} count={messages.length}>
      {messages.map((message, n) => {
        const place = placeOfMessage(message.place);
        return (
          // biome-ignore lint/suspicious/noArrayIndexKey: messages have no name of their own
          <p key={n} className={`word word-${message.tone}`}>
            {place && (
              <FindingPlace
                place={place}
                file={opened?.name}
                onShow={(to) => screen.showLine(to)}
              />
            )}
            {/* A comment of the program stays as it was written. */}
            {place && ": "}
            {message.tone === "program" ? message.text : words(messageWords(message))}
          </p>
        );
      })}
    </Tail>
  );
}

function Printed() {
  const lines = useSnapshot("printed") ?? [];
  return (
    <>
      <Tail
        label={t("Print window")}
        empty={t("The program printed nothing.")}
        count={lines.length}
      >
        <pre className="word-printed">{lines.join("\n")}</pre>
      </Tail>
      {lines.length > 0 && (
        <ActionButton action={clearPrinted} look="quiet" size="small">
          Empty
        </ActionButton>
      )}
    </>
  );
}

/** Shows the facts in the head of the file, and the findings in it. */
function FileNotes() {
  const { screen } = useHands();
  const words = useWords();
  const opened = useSnapshot("opened");
  if (!opened) return <p className="tail-empty">{t("No file is open.")}</p>;
  const told = (text: string) => words(opened.kind === "program" ? text : drawingWords(text));
  return (
    <Tail
      label={t("About the file")}
      empty={t("The file has no comments.")}
      count={opened.findings.length}
    >
      {opened.header && <pre className="word-printed">{opened.header}</pre>}
      {opened.findings.map(findingWords).map((finding) => (
        <p
          key={`${finding.code}${finding.line}${finding.column}`}
          className={`word word-${finding.level}`}
        >
          <FindingPlace
            place={placeOf(finding, opened)}
            file={opened.name}
            onShow={(place) => screen.showLine(place)}
          />
          : {told(finding.message)}
          {finding.hint && " – "}
          <em>{told(finding.hint)}</em>
        </p>
      ))}
    </Tail>
  );
}
