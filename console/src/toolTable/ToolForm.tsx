import { useState } from "react";
import { whenIdle } from "../actions/machine";
import { useHands, useShown } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import type { NumberedTool, ToolChange } from "../wire/messages";
import { t } from "../words/words";
import { type Entries, entriesOf, newEntries, toolOf } from "./tool";

interface ToolFormProps {
  tools: readonly NumberedTool[];
  /** The tool that is changed; another one is added without it. */
  edited: NumberedTool | undefined;
  change: (number: number, change: ToolChange) => void;
}

/** Name, diameter and length of a tool. */
export function ToolForm({ tools, edited, change }: ToolFormProps) {
  const { link, screen } = useHands();
  const unit = useLengthUnit();
  const refused = useShown((shown) => whenIdle({ shown, link, screen }));
  const first = edited ? entriesOf(edited, unit) : newEntries(tools);
  const [entries, setEntries] = useState<Entries>(first);
  const [wrong, setWrong] = useState<string>();
  const type = (name: keyof Entries) => (text: string) => setEntries({ ...entries, [name]: text });
  const set = () => {
    const tool = toolOf(entries, unit);
    setWrong(typeof tool === "string" ? tool : undefined);
    if (typeof tool !== "string") change(tool.number, tool.change);
  };
  const title = edited ? t("Change tool {0}", edited.number) : t("Add a tool");
  return (
    <section className="tool-table-form" aria-label={title}>
      <h3>{title}</h3>
      <div className="tool-table-fields">
        <Field
          label="Number"
          value={entries.number}
          onChange={type("number")}
          isDisabled={edited !== undefined}
        />
        <Field label="Name" value={entries.name} onChange={type("name")} placeholder="end mill" />
        <Field
          label="Diameter"
          unit={unit.linear}
          value={entries.diameter}
          onChange={type("diameter")}
        />
        <Field label="Length" unit={unit.linear} value={entries.length} onChange={type("length")} />
      </div>
      {wrong !== undefined && (
        <p className="tool-table-wrong" role="alert">
          {wrong}
        </p>
      )}
      <Button look="primary" refused={refused} onPress={set}>
        {t("Keep tool {0}", entries.number)}
      </Button>
    </section>
  );
}
