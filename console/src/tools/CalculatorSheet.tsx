import { useState } from "react";
import { evaluate, resultText } from "../app/expression";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import "./tools.css";

/** The calculator (UU, F10): inches and millimetres may be mixed. */
export function CalculatorSheet({ onClose }: { onClose: () => void }) {
  const [text, setText] = useState("");
  const [done, setDone] = useState<readonly string[]>([]);
  const value = evaluate(text);
  const keep = () => {
    if (value === undefined) return;
    setDone((now) => [`${text} = ${resultText(value)}`, ...now].slice(0, 20));
    setText(resultText(value));
  };
  return (
    <Sheet title="Calculator" onClose={onClose}>
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
