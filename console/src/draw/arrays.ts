/** The arrays of the drawing as people read them, and as the form of the operation begins with them. */

import { shortText } from "../app/units";
import type { LengthUnit } from "../units/quantity";
import type { ArrayState, OperationPart } from "../wire/messages";
import { t } from "../words/words";

export const corners: Record<string, string> = {
  bl: t("bottom left"),
  br: t("bottom right"),
  tr: t("top right"),
  tl: t("top left"),
};

export const orders: Record<string, string> = {
  row: t("row by row"),
  column: t("column by column"),
  "row-snake": t("rows forth and back"),
  "column-snake": t("columns forth and back"),
};

/** True where an array has more than one place. */
export const repeats = ({ grid: [rows, columns] }: ArrayState): boolean => rows * columns > 1;

/** The part of a form that says which level it is about. */
const isLevel = ({ value }: OperationPart): boolean =>
  value?.is === "words" && value.words.includes("block") && value.words.includes("job");

/** True for a form about a level of the arrays of the drawing. */
export const isOfArrays = (parts: readonly OperationPart[]): boolean => parts.some(isLevel);

/** The entries of a form, with the array as it is where the form is about one; in the user's unit. */
export function withArray(
  parts: readonly OperationPart[],
  entries: readonly string[],
  arrays: readonly ArrayState[],
  unit: LengthUnit,
): readonly string[] {
  const level = entries[parts.findIndex(isLevel)];
  const array = arrays.find((array) => array.level === level);
  return array
    ? entries.map((entry, n) => (parts[n] && saidOf(parts[n], array, unit)) ?? entry)
    : entries;
}

/** The value of an array for a part of the form. */
function saidOf(
  { lead, value }: OperationPart,
  { grid, gap, start, order }: ArrayState,
  unit: LengthUnit,
): string | undefined {
  if (value?.is === "grid") return grid.join("x");
  const said: Record<string, string> = {
    gap: gap.map((length) => shortText(length, unit, 6)).join(","),
    start,
    order,
  };
  return said[lead.trim()];
}
