import { evaluate } from "../app/expression";
import { shortText } from "../app/units";
import { isMetric, type LengthUnit, type Mm, mm, ofUnit, shown } from "../units/quantity";
import type { NumberedTool, ToolChange } from "../wire/messages";
import { t } from "../words/words";

/** The form of a tool as it is typed; lengths in the unit of the page. */
export interface Entries {
  readonly number: string;
  readonly name: string;
  readonly diameter: string;
  readonly length: string;
}

/** Digits of a length that is shown, in the unit of the page. */
const digits = (unit: LengthUnit) => (isMetric(unit) ? 3 : 4);

const lengthText = (length: Mm, unit: LengthUnit) => shortText(length, unit, digits(unit));

/** The form of a tool that is known. */
export const entriesOf = (tool: NumberedTool, unit: LengthUnit): Entries => ({
  number: String(tool.number),
  name: tool.name,
  diameter: tool.diameter === 0 ? "" : lengthText(tool.diameter, unit),
  length: lengthText(tool.length, unit),
});

/** The form of a tool that comes: the first number that is free. */
export function newEntries(tools: readonly NumberedTool[]): Entries {
  const taken = new Set(tools.map(({ number }) => number));
  let number = 1;
  while (taken.has(number)) number += 1;
  return { number: String(number), name: "", diameter: "", length: "" };
}

/** The tool that was typed, or the reason why it is none. */
export function toolOf(
  entries: Entries,
  unit: LengthUnit,
): { number: number; change: ToolChange } | string {
  const number = Number(entries.number);
  if (!(Number.isInteger(number) && number > 0)) return t("The number of a tool is 1 or more.");
  const length = (text: string): Mm | undefined => {
    if (text.trim() === "") return mm(0);
    const value = evaluate(text, unit);
    return value === undefined ? undefined : ofUnit(shown(value), unit);
  };
  const [diameter, long] = [length(entries.diameter), length(entries.length)];
  if (diameter === undefined || diameter < 0) return t("The diameter is no length of 0 or more.");
  if (long === undefined) return t("The length is no length.");
  return { number, change: { to: "is", name: entries.name.trim(), diameter, length: long } };
}

/** A length in words: its number, or that it is not known. */
export const lengthOf = (tool: NumberedTool, unit: LengthUnit): string =>
  tool.measured || tool.length !== 0 ? lengthText(tool.length, unit) : "–";

/** The diameter as it is told. */
export const diameterOf = ({ diameter }: NumberedTool, unit: LengthUnit): string =>
  diameter === 0 ? "–" : lengthText(diameter, unit);
