import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { Choice } from "../ui/Choice";
import { Pick } from "../ui/Pick";
import type { LengthUnit } from "../units/quantity";
import type { SettingEntry, Units } from "../wire/messages";
import { settingWord } from "../words/settingWords";
import { t } from "../words/words";
import { type Cell, partsOf } from "./tables";
import { shownUnit, shownValue, writtenValue } from "./value";

const named: Record<string, string> = { true: t("yes"), false: t("no") };

/** A value of a list by itself, in the unit of its axis. */
export function cellValue(
  { entry, at }: Cell,
  column: string,
  units: Units | undefined,
): SettingEntry {
  const [linear = "", turning] = entry.unit.split(" or ");
  const letter = column === "W" ? "C" : column;
  const turns = units?.axes.find((axis) => axis.letter === letter)?.unit === "deg";
  const unit = turning && turns ? turning : linear;
  if (at === undefined) return { ...entry, unit };
  const part = (value: string) => partsOf(value)[at] ?? value;
  const kind = /^(true|false)$/.test(part(entry.value))
    ? ({ is: "flag" } as const)
    : ({ is: "number", none: true } as const);
  return { ...entry, unit, kind, value: part(entry.value), default: part(entry.default) };
}

/** Sends a value; tells whether it holds. */
export function useSet() {
  const hands = useHands();
  return (key: string, value: string) => drive(worldOf(hands), { do: "set", key, value });
}

/** The whole value of a setting when one of its list is another. */
const whole = ({ entry, at }: Cell, value: string): string =>
  at === undefined
    ? value
    : `[${partsOf(entry.value)
        .map((old, n) => (n === at ? value : old))
        .join(", ")}]`;

interface SettingValueProps {
  cell: Cell;
  column?: string;
  label: string;
}

/** A value that is changed where it stands: it is sent when the field is left or Enter pressed. */
export function SettingValue({ cell, column = "", label }: SettingValueProps) {
  const set = useSet();
  const units = useSnapshot("units");
  const page = useLengthUnit();
  const entry = cellValue(cell, column, units);
  const shown = column === "" ? shownValue(entry, page) : short(shownValue(entry, page));
  const [text, setText] = useState(shown);
  const [wrong, setWrong] = useState(false);
  const send = async (value: string | undefined) => {
    setWrong(value === undefined);
    if (value === undefined) return;
    if (!(await set(entry.key, whole(cell, value)))) setText(shown);
  };
  const words = wordsOf(entry);
  if (words) {
    const options = words.map((word) => ({ value: word, words: named[word] ?? settingWord(word) }));
    const Way = words.length <= 3 && column === "" ? Choice : Pick;
    return (
      <Way label={label} options={options} value={entry.value} onChange={(v) => void send(v)} />
    );
  }
  const leave = () => text !== shown && void send(writtenValue(entry, text, page));
  return (
    <input
      className="setting-entry"
      aria-label={label}
      aria-invalid={wrong || undefined}
      title={wrong ? t("This is not a value of it.") : t("usual: {0}", usualText(entry, page))}
      value={text}
      spellCheck={false}
      autoComplete="off"
      onChange={(event) => setText(event.target.value)}
      onBlur={leave}
      onKeyDown={(event) => event.key === "Enter" && leave()}
    />
  );
}

/** A number as a column has room for it: the value itself stays as exact as it is. */
const short = (text: string): string => {
  const value = Number(text);
  return text.trim() === "" || Number.isNaN(value) ? text : String(Number(value.toPrecision(6)));
};

/** The words that a setting may be; nothing where a value is typed. */
function wordsOf({ kind, value }: SettingEntry): readonly string[] | undefined {
  if (kind.is === "flag") return ["true", "false"];
  if (kind.is !== "choice") return undefined;
  return kind.words.includes(value) ? kind.words : [value, ...kind.words];
}

/** The usual value with its unit. */
export function usualText(entry: SettingEntry, page: LengthUnit): string {
  const value = shownValue({ ...entry, value: entry.default }, page);
  const { unit } = shownUnit(entry, page);
  return `${named[value] ?? settingWord(value)}${unit === "" || value === "none" ? "" : ` ${unit}`}`;
}
