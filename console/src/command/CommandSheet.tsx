import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import { flushSync } from "react-dom";
import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { CommandEntry } from "../wire/messages";
import { phrase, t } from "../words/words";
import "./command-sheet.css";
import { FileButtons } from "./FileButtons";
import { FileHeader } from "./FileHeader";
import { asNamed, lastFile, runsFile } from "./lastFile";
import { ParameterField } from "./ParameterField";
import { isShown, lastEntries, rememberEntries, setShown } from "./preferences";
import {
  firstEntries,
  lineOf,
  mistakesIn,
  parted,
  resetEntries,
  sheetOrder,
  withEntry,
} from "./sheet";
import { findCommand, useCommands } from "./table";

/** The fill-in sheet of a command; settings in it are those of now. */
export function CommandSheet({ letters, given }: { letters: string; given: readonly string[] }) {
  const entry = findCommand(useCommands(true), letters);
  const current = useCurrentFile();
  const named = runsFile(letters) && !given[0] ? [current, ...given.slice(1)] : given;
  return entry ? <FilledSheet key={letters} entry={entry} given={named} /> : null;
}

/** The current part file as FP names it. */
function useCurrentFile(): string {
  return asNamed(useSnapshot("folder")?.name ?? "", useSnapshot("opened")?.name ?? "");
}

function FilledSheet({ entry, given }: { entry: CommandEntry; given: readonly string[] }) {
  const hands = useHands();
  const [entries, setEntries] = useState(() => firstEntries(entry, given));
  const [tried, setTried] = useState(false);
  const [shown, setShownHere] = useState(() => isShown(entry.letters));
  const mistakes = mistakesIn(entry, entries);
  const line = lineOf(entry, entries);
  const close = () => hands.screen.open(null);
  const reset = () => setEntries(resetEntries(entry));
  const form = useRef<HTMLFormElement>(null);
  useLastFile(entry.letters, entries[0] ?? "", (name) => {
    // Who has begun to type names another.
    flushSync(() => setEntries((now) => (now[0] ? now : withEntry(now, 0, name))));
    const field = form.current?.querySelector("input");
    if (field?.value === name) field.select();
  });
  /** A comma goes on to the next field, as on the command line. */
  const type = (n: number, text: string) => {
    const { kept, goesOn } = parted(text, n === 0);
    setEntries((now) => withEntry(now, n, kept));
    const next = goesOn ? form.current?.children[sheetOrder(entry).indexOf(n) + 1] : undefined;
    next?.querySelector<HTMLElement>("input, select, button")?.focus();
  };
  const display = () => {
    setShown(entry.letters, !shown);
    setShownHere(!shown);
  };
  const run = async () => {
    setTried(true);
    if (mistakes.size > 0) return;
    rememberEntries(entry.letters, entries);
    if (await drive(worldOf(hands), { do: "command", line })) close();
  };
  const keys = (event: KeyboardEvent) => {
    const does = event.altKey ? { r: reset, d: display }[event.key.toLowerCase()] : undefined;
    if (!does) return;
    event.preventDefault();
    does();
  };
  /** Enter is OK, also where a choice has the focus, whose buttons would only be pressed by it. */
  const enter = (event: KeyboardEvent) => {
    const chooses = event.target instanceof HTMLElement && event.target.closest(".choice");
    if (event.key !== "Enter" || !chooses) return;
    event.preventDefault();
    event.stopPropagation();
    void run();
  };
  return (
    <Sheet
      title={`${entry.letters} · ${entry.name}`}
      shape={entry.parameters.length > 6 ? "wide" : "middle"}
      onClose={close}
      foot={
        <>
          <code className="sheet-line one-line">{line}</code>
          <Button onPress={() => void navigator.clipboard?.writeText(line)}>Copy as line</Button>
          {entry.letters === "FP" && <FileButtons line={line} entries={entries} onDone={close} />}
          <Button onPress={run} look="primary">
            {entry.letters === "FP" ? t("Cut") : t("OK")}
          </Button>
        </>
      }
    >
      <p className="sheet-doc">{entry.doc}</p>
      {runsFile(entry.letters) && <FileHeader name={entries[0] ?? ""} />}
      <div className="sheet-tools">
        <Button size="small" onPress={reset} aria-keyshortcuts="Alt+R">
          {t("Reset")} <kbd>Alt R</kbd>
        </Button>
        <Recall letters={entry.letters} onRecall={setEntries} />
        <Button size="small" onPress={display} aria-keyshortcuts="Alt+D" aria-pressed={shown}>
          {phrase("Display: {0} {1}", shown ? t("on") : t("off"), <kbd>Alt D</kbd>)}
        </Button>
      </div>
      <form
        ref={form}
        className="sheet-fields"
        onKeyDown={keys}
        onKeyDownCapture={enter}
        onSubmit={(event) => {
          event.preventDefault();
          void run();
        }}
      >
        {shownParameters(entry).map(({ parameter, n }) => (
          <ParameterField
            key={`${n} ${parameter.name}`}
            parameter={parameter}
            first={n === 0}
            value={entries[n] ?? ""}
            mistake={tried ? mistakes.get(n) : undefined}
            onChange={(text) => type(n, text)}
          />
        ))}
        <button type="submit" hidden />
      </form>
    </Sheet>
  );
}

/** Offers the file that ran last where the sheet is about one and none is open. */
function useLastFile(letters: string, named: string, offer: (name: string) => void): void {
  const hands = useHands();
  const wanted = useRef(runsFile(letters) && named === "");
  useEffect(() => {
    if (!wanted.current) return;
    wanted.current = false;
    void lastFile(worldOf(hands)).then((name) => name && offer(name));
  });
}

/** Parameters in the order of the sheet, with their places in the line; those of the past are left out. */
function shownParameters(entry: CommandEntry) {
  return sheetOrder(entry).flatMap((n) => {
    const parameter = entry.parameters[n];
    return parameter && parameter.kind.is !== "obsolete" ? [{ parameter, n }] : [];
  });
}

interface RecallProps {
  letters: string;
  onRecall: (entries: readonly string[]) => void;
}

/** Brings back what was last entered for this command. */
function Recall({ letters, onRecall }: RecallProps) {
  const last = lastEntries(letters);
  return (
    <Button
      size="small"
      refused={last === undefined ? t("The command was not given before.") : undefined}
      onPress={() => last && onRecall(last)}
    >
      Recall last
    </Button>
  );
}
