import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { refusal } from "../keypad/refusal";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import { RecordedLines } from "./RecordedLines";
import "./tools.css";

const key = "kerf.scratch";

/** An empty pad takes the lines that were sent last, to be written anew. */
const recalled = (text: string, lines: readonly string[]): string =>
  text.trim() === "" ? lines.slice(-10).join("\n") : text;

/** The scratch pad (SI): lines of OpenSBP and G-code, run as a small program. */
export function ScratchSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const [text, setText] = useState(() => localStorage.getItem(key) ?? "");
  const refused = useShown(refusal);
  const recorder = useSnapshot("recorder");
  const [listed, setListed] = useState(false);
  const run = (line: string) => void drive(worldOf(hands), { do: "command", line });
  const write = (next: string) => {
    localStorage.setItem(key, next);
    setText(next);
  };
  return (
    <Sheet
      title="Scratch pad"
      onClose={onClose}
      foot={
        <>
          <span className="scratch-refused">{refused}</span>
          <Button onPress={() => setListed((now) => !now)} aria-keyshortcuts="Alt+L">
            {t("Last lines")} <kbd>{t("Alt L")}</kbd>
          </Button>
          <Button onPress={() => write("")}>Empty</Button>
          <Button
            look="go"
            refused={refused ?? (text.trim() === "" ? t("Enter a line first.") : undefined)}
            onPress={() => run(text)}
          >
            Run
          </Button>
        </>
      }
    >
      <textarea
        className="scratch"
        aria-label={t("Lines to run")}
        data-first
        rows={10}
        spellCheck={false}
        placeholder={"J2, 0, 0\nMZ, -0.1\nG1 X2 F60"}
        value={text}
        onChange={(event) => write(event.target.value)}
        onKeyDown={(event) => {
          if (!event.altKey || event.key.toLowerCase() !== "l") return;
          event.preventDefault();
          write(recalled(text, recorder?.lines ?? []));
          setListed(true);
        }}
      />
      {listed && <RecordedLines lines={recorder?.lines ?? []} onRun={run} />}
    </Sheet>
  );
}
