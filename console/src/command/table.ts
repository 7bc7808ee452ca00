/** The table of commands: menus, hints and fill-in sheets are made from it. */

import { useEffect, useState } from "react";
import { getJson } from "../link/http";
import type { CommandEntry } from "../wire/messages";

/** The menus of the FULL face in the order of the manual. */
export const menus: readonly { readonly group: string; readonly title: string }[] = [
  { group: "cut", title: "Cuts" },
  { group: "file", title: "File" },
  { group: "help", title: "Help" },
  { group: "jog", title: "Jog" },
  { group: "move", title: "Move" },
  { group: "record", title: "Record" },
  { group: "settings", title: "Settings" },
  { group: "tools", title: "Tools" },
  { group: "utilities", title: "Utilities" },
  { group: "values", title: "Values" },
  { group: "zero", title: "Zero" },
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
    if (fresh || !fetched) fetched = getJson<CommandEntry[]>("/api/commands");
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
