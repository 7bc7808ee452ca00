import { useState } from "react";
import { evaluate } from "../app/expression";
import { useLengthUnit } from "../app/useLengthUnit";
import { type Mm, ofUnit, shown } from "../units/quantity";

/** Lengths that are typed in the unit of the page, by their names. */
export function useLengths() {
  const unit = useLengthUnit();
  const [texts, setTexts] = useState<Readonly<Record<string, string>>>({});
  return {
    unit,
    text: (name: string) => texts[name] ?? "",
    type: (name: string) => (text: string) => setTexts({ ...texts, [name]: text }),
    /** The length above 0 that was typed; nothing where there is none. */
    length: (name: string): Mm | undefined => {
      const value = evaluate(texts[name] ?? "");
      return value !== undefined && value > 0 ? ofUnit(shown(value), unit) : undefined;
    },
  };
}
