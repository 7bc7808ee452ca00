import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { lastEntries, rememberEntries } from "../command/preferences";
import { type Entries, firstEntries, lineOf, mistakesIn } from "../command/sheet";
import { refusal } from "../keypad/refusal";
import type { CommandEntry } from "../wire/messages";
import { t } from "../words/words";

export interface Maker {
  readonly entries: Entries;
  setEntries: (entries: Entries) => void;
  /** Mistakes by the place of their entry. */
  readonly mistakes: ReadonlyMap<number, string>;
  /** The reason for which nothing is made now. */
  readonly refused: string | undefined;
  /** The file that is open was made of these entries. */
  readonly isMade: boolean;
  make: () => void;
}

/** The form of a virtual tool that makes a file of this name: what is entered, and whether it is made. */
export function useMaker(entry: CommandEntry, file: string): Maker {
  const hands = useHands();
  const refused = useShown(refusal);
  const opened = useSnapshot("opened");
  const job = useSnapshot("job");
  const { letters } = entry;
  const [entries, setEntries] = useState<Entries>(
    () => lastEntries(letters) ?? firstEntries(entry, []),
  );
  const [made, setMade] = useState<string>();
  const mistakes = mistakesIn(entry, entries);
  const line = lineOf(entry, entries);
  // Refused entries leave an older program open: only a command that came to its end made this one.
  if (made !== line && job?.command === line && job.ended === "ok") setMade(line);
  const make = () => {
    rememberEntries(letters, entries);
    setMade(undefined);
    void drive(worldOf(hands), { do: "command", line });
  };
  return {
    entries,
    setEntries,
    mistakes,
    refused: mistakes.size > 0 ? t("An entry is wrong.") : refused,
    isMade: made === line && opened?.name === file,
    make,
  };
}
