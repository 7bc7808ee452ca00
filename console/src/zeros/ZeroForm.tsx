import { useState } from "react";
import { evaluate } from "../app/expression";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Pick } from "../ui/Pick";
import { ofAxisUnit, shownOnAxis } from "../units/quantity";
import type { AxisUnits, Units, ZeroChange } from "../wire/messages";
import { t } from "../words/words";
import { changeOf, type Meaning } from "./change";

const meanings = [
  { value: "reads", words: "The tool is at" },
  { value: "lies", words: "It lies at, from home" },
] as const;

interface ZeroFormProps {
  names: readonly string[];
  name: string;
  axes: readonly { readonly axis: AxisUnits; readonly at: number }[];
  units: Units;
  refused: string | undefined;
  change: (name: string, change: ZeroChange) => void;
  setName: (name: string) => void;
}

/** Sets a zero point: by what axes read where the tool is, or by its place. */
export function ZeroForm({ names, name, axes, units, refused, change, setName }: ZeroFormProps) {
  const [meaning, setMeaning] = useState<Meaning>("reads");
  const [entries, setEntries] = useState<Record<string, string>>({});
  const [wrong, setWrong] = useState<string>();
  const number = (text: string, axis: AxisUnits) => {
    const value = evaluate(text, units);
    return value === undefined ? undefined : ofAxisUnit(shownOnAxis(value), axis);
  };
  const set = () => {
    const made = changeOf(axes, entries, number, meaning);
    setWrong(typeof made === "string" ? made : undefined);
    if (typeof made !== "string") change(name, made);
  };
  return (
    <section className="zeros-form" aria-label={t("Set a zero point")}>
      <h3>{t("Set a zero point")}</h3>
      <Pick
        label="Zero point"
        labelled
        options={names.map((value) => ({ value, words: value }))}
        value={name}
        onChange={setName}
      />
      <Choice label="Numbers mean" options={meanings} value={meaning} onChange={setMeaning} />
      <div className="zeros-axes">
        {axes.map(({ axis: { letter, unit } }) => (
          <Field
            key={letter}
            label={letter}
            unit={unit}
            placeholder="stays"
            value={entries[letter] ?? ""}
            onChange={(text) => setEntries({ ...entries, [letter]: text })}
          />
        ))}
      </div>
      {wrong !== undefined && (
        <p className="zeros-wrong" role="alert">
          {wrong}
        </p>
      )}
      <Button look="primary" refused={refused} onPress={set}>
        {t("Set {0}", name)}
      </Button>
    </section>
  );
}
