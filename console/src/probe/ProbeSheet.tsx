import { useState } from "react";
import { drive } from "../actions/ask";
import { start } from "../actions/job";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { useWords } from "../app/useWords";
import { ParameterField } from "../command/ParameterField";
import { lastEntries, rememberEntries } from "../command/preferences";
import { type Entries, firstEntries, lineOf, mistakesIn, withEntry } from "../command/sheet";
import { findCommand, useCommands } from "../command/table";
import { refusal } from "../keypad/refusal";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { CommandEntry } from "../wire/messages";
import { t } from "../words/words";
import { isChecked, seen, unchecked } from "./contact";
import { entriesOf, type Kind, kinds } from "./kinds";
import { Picture } from "./Picture";
import "./probe.css";

const letters = "TP";

/** Finds places and angles with the probe, and sets zero there: a program is made, looked at and started. */
export function ProbeSheet({ onClose }: { onClose: () => void }) {
  const entry = findCommand(useCommands(true), letters);
  return entry ? <ProbeForm entry={entry} onClose={onClose} /> : null;
}

/** The kind that an entry names; the first where it names none. */
const kindOf = (word: string | undefined): Kind | undefined =>
  kinds.find((kind) => kind.word === word) ?? kinds[0];

function ProbeForm({ entry, onClose }: { entry: CommandEntry; onClose: () => void }) {
  const hands = useHands();
  const refused = useShown(refusal);
  const opened = useSnapshot("opened");
  const job = useSnapshot("job");
  const [entries, setEntries] = useState<Entries>(
    () => lastEntries(letters) ?? firstEntries(entry, []),
  );
  const [made, setMade] = useState<string>();
  const kind = kindOf(entries[0]);
  if (!kind) return null;
  const mistakes = mistakesIn(entry, entries);
  const line = lineOf(entry, entries);
  // Refused entries leave an older program open: only a command that came to its end made this one.
  if (made !== line && job?.command === line && job.ended === "ok") setMade(line);
  const make = () => {
    rememberEntries(letters, entries);
    setMade(undefined);
    void drive(worldOf(hands), { do: "command", line });
  };
  const isMade = made === line && opened?.name === "probe.nc";
  return (
    <Sheet
      title={t("Probe")}
      shape="side"
      onClose={onClose}
      foot={
        <>
          <Touched isMade={isMade} />
          <Button
            look="primary"
            refused={mistakes.size > 0 ? t("An entry is wrong.") : refused}
            onPress={make}
          >
            Make the program
          </Button>
        </>
      }
    >
      <Kinds kind={kind} choose={(word) => setEntries(withEntry(entries, 0, word))} />
      <p className="probe-words">{kind.begins}</p>
      <div className="probe-fields">
        {entriesOf(kind, entry).map((n) => {
          const parameter = entry.parameters[n];
          return (
            parameter && (
              <ParameterField
                key={parameter.name}
                parameter={parameter}
                first={false}
                value={entries[n] ?? ""}
                mistake={mistakes.get(n)}
                onChange={(text) => setEntries(withEntry(entries, n, text))}
              />
            )
          );
        })}
      </div>
      <Outcome />
    </Sheet>
  );
}

function Kinds({ kind, choose }: { kind: Kind; choose: (word: string) => void }) {
  return (
    <div className="probe-kinds" role="radiogroup" aria-label={t("What is found")}>
      {kinds.map(({ word, name, scene }) => (
        // biome-ignore lint/a11y/useSemanticElements: a picture stands in it
        <button
          type="button"
          role="radio"
          key={word}
          aria-checked={word === kind.word}
          className="probe-kind"
          onClick={() => choose(word)}
        >
          <Picture scene={scene} />
          {name}
        </button>
      ))}
    </div>
  );
}

/** The input of the probe, as G-code has it. */
const probeInput = 1;

/** The check of the probe, and Start behind it. */
function Touched({ isMade }: { isMade: boolean }) {
  const io = useSnapshot("io");
  const isClosed = io?.inputs.find(({ number }) => number === probeInput)?.on ?? false;
  const [contact, setContact] = useState(unchecked);
  if (contact.isClosed !== isClosed) setContact(seen(contact, isClosed));
  return (
    <section className="probe-check" aria-label={t("Check of the probe")}>
      <p role="status" data-checked={isChecked(contact)}>
        {words(contact)}
      </p>
      {isMade && isChecked(contact) && (
        <ActionButton action={start} look="go">
          {t("Start probing")}
        </ActionButton>
      )}
    </section>
  );
}

function words(contact: { readonly isClosed: boolean; readonly wasClosed: boolean }): string {
  if (contact.isClosed) return t("Input 1 is closed: take the plate away from the tool.");
  if (!contact.wasClosed)
    return t(
      "Touch the plate or the probe by hand: its input 1 has to close before anything moves.",
    );
  return t("The probe works.");
}

/** The result of the last run, or the reason for which nothing was set. */
function Outcome() {
  const words = useWords();
  const job = useSnapshot("job");
  const printed = useSnapshot("printed") ?? [];
  if (job?.file !== "probe.nc" || job.ended === null) return null;
  if (job.ended !== "ok")
    return (
      <p className="probe-wrong" role="alert">
        {t("Nothing was set. {0}", words(job.error?.message ?? ""))}
      </p>
    );
  const found = printed.findLast((text) => text.startsWith("Probed: "));
  return found === undefined ? null : (
    <p className="probe-found" role="status">
      {found}
    </p>
  );
}
