import { useState } from "react";
import { drive } from "../actions/ask";
import { frameJob } from "../actions/frame";
import { findHome, home, unlessReady } from "../actions/machine";
import { useHands, useShown, worldOf } from "../app/context";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { phrase, t } from "../words/words";
import { filledIn, keepMacros, type Macro, readMacros, valuesOf } from "./macros";

/** Ways of the machine and macros of this browser, a button each. */
export function MacrosSheet({ onClose }: { onClose: () => void }) {
  const [macros, setMacros] = useState(readMacros);
  const [chosen, setChosen] = useState<{ at: number; is: "runs" | "edits" } | null>(null);
  const keep = (next: readonly Macro[]) => {
    keepMacros(next);
    setMacros(next);
    setChosen(null);
  };
  const at = chosen?.at ?? macros.length;
  const macro = macros[at] ?? { name: "", lines: "" };
  return (
    <Sheet
      title="Macros"
      onClose={onClose}
      foot={
        <Button onPress={() => setChosen({ at: macros.length, is: "edits" })}>New macro…</Button>
      }
    >
      <div className="macros">
        <ActionButton action={home}>Go to work zero</ActionButton>
        <ActionButton action={findHome}>Find the machine's home</ActionButton>
        <ActionButton action={frameJob}>Frame the job</ActionButton>
      </div>
      <ul className="macros-own" aria-label={t("Macros")}>
        {macros.map(({ name }, n) => (
          <li key={name}>
            <Button look="primary" onPress={() => setChosen({ at: n, is: "runs" })}>
              {name}
            </Button>
            <Button
              size="small"
              aria-label={t("Edit {0}", name)}
              onPress={() => setChosen({ at: n, is: "edits" })}
            >
              Edit…
            </Button>
          </li>
        ))}
      </ul>
      {chosen?.is === "runs" && <MacroRun key={macro.name} macro={macro} onDone={onClose} />}
      {chosen?.is === "edits" && (
        <MacroForm
          key={at}
          macro={macro}
          taken={macros.filter((_, n) => n !== at).map(({ name }) => name)}
          onKeep={(next) => keep([...macros.slice(0, at), next, ...macros.slice(at + 1)])}
          onRemove={() => keep(macros.filter((_, n) => n !== at))}
        />
      )}
    </Sheet>
  );
}

/** Asks for the values of a macro, shows what runs, and runs it. */
function MacroRun({ macro, onDone }: { macro: Macro; onDone: () => void }) {
  const hands = useHands();
  const asked = valuesOf(macro.lines);
  const [values, setValues] = useState<Record<string, string>>(() =>
    Object.fromEntries(asked.map(({ name, first }) => [name, first])),
  );
  const unready = useShown((shown) => unlessReady({ ...worldOf(hands), shown }));
  const lacking = asked.find(({ name }) => (values[name] ?? "").trim() === "");
  const refused = lacking ? t("Enter {0} first.", lacking.name) : unready;
  const line = filledIn(macro.lines, values);
  const run = async () => {
    if (refused === undefined && (await drive(worldOf(hands), { do: "command", line }))) onDone();
  };
  return (
    <form
      className="macro"
      aria-label={t("Run {0}", macro.name)}
      onSubmit={(event) => {
        event.preventDefault();
        void run();
      }}
    >
      {asked.map(({ name }, n) => (
        <Field
          key={name}
          label={name}
          value={values[name] ?? ""}
          first={n === 0}
          onChange={(value) => setValues((now) => ({ ...now, [name]: value }))}
        />
      ))}
      <pre>{line}</pre>
      <Button look="go" refused={refused} onPress={() => void run()}>
        {t("Run {0}", macro.name)}
      </Button>
    </form>
  );
}

interface MacroFormProps {
  macro: Macro;
  /** Names of the others. */
  taken: readonly string[];
  onKeep: (macro: Macro) => void;
  onRemove: () => void;
}

function MacroForm({ macro, taken, onKeep, onRemove }: MacroFormProps) {
  const [name, setName] = useState(macro.name);
  const [lines, setLines] = useState(macro.lines);
  const refused =
    name.trim() === ""
      ? t("Enter a name first.")
      : taken.includes(name.trim())
        ? t("Another macro has this name.")
        : lines.trim() === ""
          ? t("Enter its lines first.")
          : undefined;
  return (
    <form
      className="macro"
      aria-label={t("Macro")}
      onSubmit={(event) => {
        event.preventDefault();
        if (refused === undefined) onKeep({ name: name.trim(), lines: lines.trim() });
      }}
    >
      <Field label="Name" value={name} onChange={setName} first />
      <label className="macro-lines">
        {phrase("Lines of OpenSBP; {0} asks for depth", <code>{"{depth=0.25}"}</code>)}
        <textarea rows={5} value={lines} onChange={(event) => setLines(event.target.value)} />
      </label>
      <div className="macros">
        <Button type="submit" look="primary" refused={refused}>
          Keep
        </Button>
        <Button
          refused={macro.name === "" ? t("It is not kept yet.") : undefined}
          onPress={onRemove}
        >
          Remove
        </Button>
      </div>
    </form>
  );
}
