import { useState } from "react";
import { useHands, useSnapshot } from "../../app/context";
import { drawingWords } from "../../app/drawingWords";
import { useLengthUnit } from "../../app/useLengthUnit";
import { useWords } from "../../app/useWords";
import { Button } from "../../ui/Button";
import { Choice } from "../../ui/Choice";
import { Field } from "../../ui/Field";
import { Pick } from "../../ui/Pick";
import { Sheet } from "../../ui/Sheet";
import type { ArrayState, OperationEntry, OperationPart } from "../../wire/messages";
import { operationDoc, operationTitle, operationWord } from "../../words/operations";
import { t } from "../../words/words";
import { isOfArrays, repeats, withArray } from "../arrays";
import { groups } from "../colours";
import { clauseOf, type Entries, exampleOf, firstEntries, labelsOf, wayOf } from "./form";
import "./operations.css";

interface OperationSheetProps {
  entry: OperationEntry;
  onClose: () => void;
}

/** An operation of the table as a form, for numbers that no hand shows. */
export function OperationSheet({ entry, onClose }: OperationSheetProps) {
  const hands = useHands();
  const unit = useLengthUnit();
  const drawing = useSnapshot("drawing");
  const arrays = drawing?.arrays ?? [];
  const given = { unit, selected: drawing?.selection ?? [] };
  const [which, setWhich] = useState(() => firstVariant(entry, arrays));
  const parts = entry.variants[Number(which)]?.parts ?? [];
  const present = (parts: readonly OperationPart[], entries: Entries) =>
    withArray(parts, entries, arrays, unit);
  const [entries, setEntries] = useState<Entries>(() => present(parts, firstEntries(parts, given)));
  const enter = (at: number, text: string) => {
    const next = entries.map((old, n) => (n === at ? text : old));
    // Another array is shown as it is.
    setEntries(parts[at]?.value?.is === "words" && at === 0 ? present(parts, next) : next);
  };
  const [tried, setTried] = useState(false);
  const [told, setTold] = useState<Told>(nothingTold);
  const made = clauseOf(entry, parts, entries, given);
  const wrong = "wrong" in made && tried ? made.wrong : new Map<number, string>();
  const choose = (next: string) => {
    setWhich(next);
    const others = entry.variants[Number(next)]?.parts ?? [];
    setEntries(present(others, firstEntries(others, given)));
    setTried(false);
    setTold(nothingTold);
  };
  const apply = async () => {
    setTried(true);
    if ("wrong" in made) return;
    const op = { op: "do" as const, clauses: made.clause };
    const { problem, notes } = await hands.link.ask({ do: "draw", op });
    if (problem) return setTold({ refused: true, texts: [problem.text] });
    if (notes.length > 0) return setTold({ refused: false, texts: notes });
    onClose();
  };
  const labels = labelsOf(parts);
  return (
    <Sheet
      title={operationTitle(entry)}
      shape="side"
      onClose={onClose}
      foot={
        <>
          <Button onPress={onClose}>Close</Button>
          <Button look="primary" onPress={() => void apply()}>
            Apply
          </Button>
        </>
      }
    >
      <form
        className="operation-form"
        onSubmit={(event) => {
          event.preventDefault();
          void apply();
        }}
      >
        <p className="operation-doc">{sentence(operationDoc(entry))}</p>
        {entry.variants.length > 1 && (
          <Pick
            label="How"
            value={which}
            options={entry.variants.map(({ parts }, n) => ({
              value: String(n),
              words: wayOf(parts),
            }))}
            onChange={choose}
          />
        )}
        {parts.map((part, n) => (
          <PartField
            // biome-ignore lint/suspicious/noArrayIndexKey: parts have no other name, and stay in place
            key={`${which} ${n}`}
            part={part}
            label={labels[n] ?? ""}
            unit={unit.linear}
            text={entries[n] ?? ""}
            error={wrong.get(n)}
            first={n === 0}
            onChange={(text) => enter(n, text)}
          />
        ))}
        <Outcome told={told} />
        <button type="submit" hidden />
      </form>
    </Sheet>
  );
}

/** The form that is shown first: that of the drawing's arrays where there are any. */
function firstVariant({ variants }: OperationEntry, arrays: readonly ArrayState[]): string {
  const found = variants.findIndex(({ parts }) => isOfArrays(parts));
  return String(found >= 0 && arrays.some(repeats) ? found : 0);
}

/** Result of an operation: the reason of a refusal, or notes on one that was done. */
interface Told {
  readonly refused: boolean;
  readonly texts: readonly string[];
}

const nothingTold: Told = { refused: false, texts: [] };

function Outcome({ told: { refused, texts } }: { told: Told }) {
  const words = useWords();
  if (texts.length === 0) return null;
  return (
    <div
      className={refused ? "operation-told operation-refused" : "operation-told operation-done"}
      role="alert"
    >
      <p>{refused ? t("Nothing was changed:") : t("Done. What was noticed:")}</p>
      <ul>
        {texts.map((text) => (
          <li key={text}>{sentence(words(drawingWords(text)))}</li>
        ))}
      </ul>
    </div>
  );
}

const sentence = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

interface PartFieldProps {
  part: OperationPart;
  label: string;
  unit: string;
  text: string;
  error: string | undefined;
  first: boolean;
  onChange: (text: string) => void;
}

function PartField({ part, label, unit, text, error, first, onChange }: PartFieldProps) {
  const { value, optional } = part;
  if (!value) {
    // A word that is always said needs no field.
    if (!optional) return null;
    return (
      <label className="operation-check">
        <input
          type="checkbox"
          checked={text !== ""}
          onChange={() => onChange(text === "" ? "on" : "")}
        />
        {label}
      </label>
    );
  }
  if (value.is === "words" || value.is === "group") {
    return <WordField {...{ label, text, optional, onChange }} words={wordsOf(value)} />;
  }
  const lengths = ["pair", "vertex", "triple", "length", "arc"].includes(value.is);
  return (
    <Field
      label={label}
      value={text}
      onChange={onChange}
      isRequired={!optional}
      unit={lengths ? unit : ""}
      placeholder={exampleOf(part)}
      error={error}
      first={first}
    />
  );
}

const wordsOf = (value: { is: string; words?: readonly string[] }): readonly string[] =>
  value.words ?? groups;

interface WordFieldProps {
  label: string;
  text: string;
  words: readonly string[];
  optional: boolean;
  onChange: (text: string) => void;
}

function WordField({ label, text, words, optional, onChange }: WordFieldProps) {
  const options = [
    ...(optional ? [{ value: "", words: t("as it is") }] : []),
    ...words.map((word) => ({ value: word, words: operationWord(word) })),
  ];
  return (
    <div className="operation-words">
      <span className="field-label">{label}</span>
      {options.length > 4 ? (
        <Pick label={label} options={options} value={text} onChange={onChange} />
      ) : (
        <Choice label={label} options={options} value={text} onChange={onChange} />
      )}
    </div>
  );
}
