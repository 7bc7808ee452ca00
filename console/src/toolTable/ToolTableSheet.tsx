import { useState } from "react";
import { drive } from "../actions/ask";
import { unlessReady, whenIdle } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { NumberedTool, ToolChange, ToolTable } from "../wire/messages";
import { t } from "../words/words";
import { ChangingTools } from "./ChangingTools";
import { ToolForm } from "./ToolForm";
import { diameterOf, lengthOf } from "./tool";
import "./tool-table.css";

/** The tools by their numbers: seen, changed, forgotten, measured; where they are changed and measured. */
export function ToolTableSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const table = useSnapshot("tools");
  const [edited, setEdited] = useState<NumberedTool>();
  if (!table) return null;
  const change = (number: number, change: ToolChange) =>
    void drive(worldOf(hands), { do: "tool", number, change });
  const measure = (number: number) =>
    void drive(worldOf(hands), {
      do: "command",
      line: `&Tool = ${number}\n&tool_measure = 1\nC9`,
    });
  return (
    <Sheet title={t("Tools by their numbers")} shape="side" onClose={onClose}>
      <p className="tool-table-words">
        {t(
          "T2 M6 in G-code, and &Tool = 2 with C9 in OpenSBP, ask for the tool by its number and what stands here. A length that the sensor has measured is in Z zero; others are for G43.",
        )}
      </p>
      {!table.findsHome && table.tools.some(({ measured }) => measured) && (
        <p className="tool-table-words" role="note">
          {t(
            "This machine finds no home of Z: lengths that were measured hold until its location is set anew, or it is moved while it is off. Measure the tools again then.",
          )}
        </p>
      )}
      <Tools {...{ table, change, measure, edit: setEdited }} />
      <ToolForm
        key={edited ? `changes ${edited.number}` : `adds to ${table.tools.length}`}
        tools={table.tools}
        edited={edited}
        change={(number, to) => {
          setEdited(undefined);
          change(number, to);
        }}
      />
      <ChangingTools />
    </Sheet>
  );
}

interface ToolsProps {
  table: ToolTable;
  change: (number: number, change: ToolChange) => void;
  measure: (number: number) => void;
  edit: (tool: NumberedTool) => void;
}

function Tools({ table: { tools, inSpindle, hasSensor }, change, measure, edit }: ToolsProps) {
  const { link, screen } = useHands();
  const unit = useLengthUnit();
  const refused = useShown((shown) => whenIdle({ shown, link, screen }));
  const moves = useShown((shown) => unlessReady({ shown, link, screen }));
  if (tools.length === 0) return <p role="status">{t("No tool is known yet.")}</p>;
  return (
    <table className="tool-table">
      <thead>
        <tr>
          <th>{t("Tool")}</th>
          <th>{`${t("Diameter")} ${unit.linear}`}</th>
          <th>{`${t("Length")} ${unit.linear}`}</th>
          <td />
        </tr>
      </thead>
      <tbody>
        {tools.map((tool) => (
          <tr key={tool.number} aria-current={tool.number === inSpindle ? "true" : undefined}>
            <th scope="row">
              {tool.number} {tool.name}
              {tool.number === inSpindle && <em>{t("in the spindle")}</em>}
            </th>
            <td>{diameterOf(tool, unit)}</td>
            <td>
              {lengthOf(tool, unit)}
              {tool.measured && <em>{t("measured")}</em>}
            </td>
            <td>
              <div className="tool-table-acts">
                {tool.number === inSpindle ? (
                  <Button
                    size="small"
                    refused={hasSensor ? moves : t("No sensor for tools is set up.")}
                    aria-label={t("Measure tool {0}", tool.number)}
                    onPress={() => measure(tool.number)}
                  >
                    Measure
                  </Button>
                ) : (
                  <Button
                    size="small"
                    refused={refused}
                    aria-label={t("Tool {0} is in the spindle", tool.number)}
                    onPress={() => change(tool.number, { to: "in" })}
                  >
                    Is in
                  </Button>
                )}
                <Button
                  size="small"
                  refused={refused}
                  aria-label={t("Change tool {0}", tool.number)}
                  onPress={() => edit(tool)}
                >
                  Change
                </Button>
                <Button
                  size="small"
                  refused={refused}
                  aria-label={t("Forget tool {0}", tool.number)}
                  onPress={() => change(tool.number, { to: "gone" })}
                >
                  Forget
                </Button>
              </div>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
