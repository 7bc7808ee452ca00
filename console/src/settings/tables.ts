/** Settings of a topic as tables: axes, or inputs, side by side. */

import type { SettingArea, SettingEntry } from "../wire/messages";
import { docOf, shortName } from "./names";

/** A value in a table: of a setting, or one of its list. */
export interface Cell {
  readonly entry: SettingEntry;
  /** Its place in the list; the whole value without. */
  readonly at?: number;
}

export interface Row {
  readonly name: string;
  readonly doc: string;
  readonly cells: ReadonlyMap<string, Cell>;
}

export interface Table {
  readonly columns: readonly string[];
  readonly rows: readonly Row[];
}

export interface Topic {
  readonly title: string;
  readonly manual: string;
  readonly tables: readonly Table[];
  /** Settings with one value. */
  readonly single: readonly SettingEntry[];
}

const axisColumns = ["XY", "X", "Y", "Z", "X2", "Y2", "Z2", "A", "B", "C", "W"];
const axes = ["X", "Y", "Z", "A", "B", "C"];

/** Longer lists stay a line of numbers. */
const mostColumns = 12;

interface Place {
  readonly row: string;
  readonly columns: readonly (readonly [string, Cell])[];
  /** Lists that are counted stand in a table of their own. */
  readonly kind: string;
}

/** The values of a list, as they are written. */
export const partsOf = (value: string): string[] =>
  value
    .replace(/[[\]]/g, "")
    .split(",")
    .map((part) => part.trim());

/** The row and the column of a setting; nothing where it stands in no table. */
function placeOf(entry: SettingEntry): Place | undefined {
  const parts = entry.key.split(".");
  const n = parts.findIndex((part) => axisColumns.includes(part.toUpperCase()));
  if (n > 0) {
    const row = parts.filter((_, at) => at !== n).join(".");
    return { row, kind: "axes", columns: [[parts[n]?.toUpperCase() ?? "", { entry }]] };
  }
  if (entry.kind.is !== "list") return undefined;
  const { length } = partsOf(entry.value);
  if (length !== entry.kind.length || length < 3 || length > mostColumns) return undefined;
  const isOfAxes = length === axes.length;
  const columns = partsOf(entry.value).map((_, at) => {
    return [columnOf(entry, length, at), { entry, at }] as const;
  });
  return { row: entry.key, kind: isOfAxes ? "axes" : `list ${length}`, columns };
}

/** The heading of a value of a list: its axis, its bit, or its number. */
function columnOf({ key }: SettingEntry, length: number, at: number): string {
  if (key === "rotary") return axes[at + 3] ?? "";
  if (length === axes.length || key === "view.table_mm") return axes[at] ?? "";
  return key.startsWith("ports.") ? `${at}` : `${at + 1}`;
}

/** Sorts an area into tables; settings keep their order. */
export function topicOf(area: SettingArea): Topic {
  const kinds = new Map<string, Map<string, Row>>();
  const single: SettingEntry[] = [];
  for (const entry of area.settings) {
    const place = placeOf(entry);
    if (!place) {
      single.push(entry);
      continue;
    }
    const rows = kinds.get(place.kind) ?? new Map<string, Row>();
    kinds.set(place.kind, rows);
    const row = rows.get(place.row);
    const name = shortName(entry.key, place.kind === "axes");
    rows.set(place.row, {
      name,
      doc: row?.doc ?? docOf(entry),
      cells: new Map([...(row?.cells ?? []), ...place.columns]),
    });
  }
  const tables = [...kinds.values()].map((rows) => tableOf([...rows.values()]));
  return { title: area.title, manual: area.manual, tables, single };
}

function tableOf(rows: readonly Row[]): Table {
  const used = new Set(rows.flatMap((row) => [...row.cells.keys()]));
  const known = axisColumns.filter((column) => used.has(column));
  return { columns: known.length > 0 ? known : [...used], rows };
}
