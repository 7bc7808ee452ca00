import { useState } from "react";
import { useHands } from "../app/context";
import { evaluate, resultText } from "../app/expression";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import "./tools.css";

/**
 * The calculator (UU, F10): inches and millimetres may be mixed. The result goes into the field that
 * it was called from.
 */
export function CalculatorSheet({ field }: { field: HTMLInputElement | null }) {
  const { screen } = useHands();
  const close = () => screen.calculate(false);
  const [text, setText] = useState("");
  const [done, setDone] = useState<readonly string[]>([]);
  const value = evaluate(text);
  const keep = () => {
    if (value === undefined) return;
    setDone((now) => [`${text} = ${resultText(value)}`, ...now].slice(0, 20));
    setText(resultText(value));
  };
  return (
    <Sheet
      title="Calculator"
      onClose={close}
      foot={
        field?.isConnected && (
          <Button
            look="primary"
            refused={value === undefined ? t("There is no result yet.") : undefined}
            onPress={() => {
              if (value !== undefined) enter(field, resultText(value));
              close();
            }}
          >
            {t("Paste into {0}", nameOf(field))}
          </Button>
        )
      }
    >
      <form
        onSubmit={(event) => {
          event.preventDefault();
          keep();
        }}
      >
        <Field
          label="Expression"
          value={text}
          onChange={setText}
          placeholder="12+11/16"
          hint="+ − * / ^ ( ), sqr sin cos tan atn in radians, pi, 3/4in + 2mm"
          first
        />
      </form>
      <output className="calculator-result">{value === undefined ? "…" : resultText(value)}</output>
      <ol className="calculator-done">
        {done.map((line) => (
          <li key={line}>{line}</li>
        ))}
      </ol>
    </Sheet>
  );
}

/** Name of a field. */
const nameOf = (field: HTMLInputElement): string =>
  field.labels?.[0]?.querySelector(".hidden-text")?.textContent?.toLowerCase() ??
  field.labels?.[0]?.firstChild?.textContent ??
  t("the field");

/** Enters a result as typing would: it takes the place of a value, or joins what the field has more of. */
function enter(field: HTMLInputElement, text: string) {
  const [from, to] =
    field.dataset.takes === "more"
      ? [field.selectionStart ?? field.value.length, field.selectionEnd ?? field.value.length]
      : [0, field.value.length];
  const value = field.value.slice(0, from) + text + field.value.slice(to);
  Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, value);
  field.dispatchEvent(new Event("input", { bubbles: true }));
}
