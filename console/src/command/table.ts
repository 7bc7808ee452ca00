/** The table of commands: menus, hints and fill-in sheets are made from it. */

import { useEffect, useState } from "react";
import { getJson } from "../link/http";
import type { CommandEntry } from "../wire/messages";
import { commandWords } from "../words/commands";
import { t } from "../words/words";

/** The menus of the FULL face in the order of the manual. */
export const menus: readonly { readonly group: string; readonly title: string }[] = [
  { group: "cut", title: t("Cuts") },
  { group: "file", title: t("File") },
  { group: "help", title: t("Help") },
  { group: "jog", title: t("Jog") },
  { group: "move", title: t("Move") },
  { group: "record", title: t("Record") },
  { group: "settings", title: t("Settings") },
  { group: "tools", title: t("Tools") },
  { group: "utilities", title: t("Utilities") },
  { group: "values", title: t("Values") },
  { group: "zero", title: t("Zero") },
];

export const inMenu = (table: readonly CommandEntry[], group: string): CommandEntry[] =>
  table.filter((entry) => entry.group === group).sort((a, b) => a.letters.localeCompare(b.letters));

export const findCommand = (
  table: readonly CommandEntry[],
  letters: string,
): CommandEntry | undefined => table.find((entry) => entry.letters === letters.toUpperCase());

let fetched: Promise<readonly CommandEntry[]> | undefined;

/** The table of the server; empty until it came. With `fresh`, settings in it are those of now. */
export function useCommands(fresh = false): readonly CommandEntry[] {
  const [table, setTable] = useState<readonly CommandEntry[]>([]);
  useEffect(() => {
    let wanted = true;
    if (fresh || !fetched) fetched = getJson<CommandEntry[]>("/api/commands").then(commandWords);
    fetched.then(
      (entries) => wanted && setTable(entries),
      () => {
        fetched = undefined;
      },
    );
    return () => {
      wanted = false;
    };
  }, [fresh]);
  return table;
}
