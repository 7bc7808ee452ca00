import { useSnapshot } from "../app/context";
import { useWords } from "../app/useWords";
import { withEntry } from "../command/sheet";
import { findCommand, useCommands } from "../command/table";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { CommandEntry } from "../wire/messages";
import { findingWords } from "../words/findings";
import { t } from "../words/words";
import { EntryFields } from "./EntryFields";
import { entriesOf, type Kind, kinds } from "./kinds";
import { Picture } from "./Picture";
import { Touched } from "./Touched";
import { useMaker } from "./useMaker";
import "./probe.css";

/** Finds places and angles with the probe, and sets zero there: a program is made, looked at and started. */
export function ProbeSheet({ onClose }: { onClose: () => void }) {
  const entry = findCommand(useCommands(true), "TP");
  return entry ? <ProbeForm entry={entry} onClose={onClose} /> : null;
}

/** The kind that an entry names; the first where it names none. */
const kindOf = (word: string | undefined): Kind | undefined =>
  kinds.find((kind) => kind.word === word) ?? kinds[0];

/** The input of the probe, as G-code has it. */
const probeInput = 1;

function ProbeForm({ entry, onClose }: { entry: CommandEntry; onClose: () => void }) {
  const maker = useMaker(entry, "probe.nc");
  const { entries, setEntries, refused, isMade, make } = maker;
  const kind = kindOf(entries[0]);
  if (!kind) return null;
  return (
    <Sheet
      title={t("Probe")}
      shape="side"
      onClose={onClose}
      foot={
        <>
          <Touched isMade={isMade} input={probeInput} />
          <Button look="primary" refused={refused} onPress={make}>
            Make the program
          </Button>
        </>
      }
    >
      <Kinds kind={kind} choose={(word) => setEntries(withEntry(entries, 0, word))} />
      <p className="probe-words">{kind.begins}</p>
      <EntryFields entry={entry} maker={maker} places={entriesOf(kind, entry)} />
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

/** The result of the last run, or the reason for which nothing was set. */
function Outcome() {
  const words = useWords();
  const job = useSnapshot("job");
  const printed = useSnapshot("printed") ?? [];
  if (job?.file !== "probe.nc" || job.ended === null) return null;
  if (job.ended !== "ok")
    return (
      <p className="probe-wrong" role="alert">
        {t("Nothing was set. {0}", words(job.error ? findingWords(job.error).message : ""))}
      </p>
    );
  const found = printed.findLast((text) => text.startsWith("Probed: "));
  return found === undefined ? null : (
    <p className="probe-found" role="status">
      {found}
    </p>
  );
}
