import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import type { NamedValue } from "../wire/messages";
import { t } from "../words/words";
import { changedLines, linesOf, notAVariable } from "./variableLines";

interface VariableLinesProps {
  variables: readonly NamedValue[];
  onDone: () => void;
}

/** The variables as text: a line changes one, a new line adds one (UL). */
export function VariableLines({ variables, onDone }: VariableLinesProps) {
  const hands = useHands();
  const [before] = useState(() => linesOf(variables));
  const [text, setText] = useState(before);
  const wrong = notAVariable(text);
  const line = changedLines(before, text);
  const save = async () => {
    if (line === "" || (await drive(worldOf(hands), { do: "command", line }))) onDone();
  };
  return (
    <div className="variable-lines">
      <textarea
        className="scratch"
        aria-label={t("Variables, a line each")}
        rows={12}
        spellCheck={false}
        placeholder={t("&name = 4")}
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      <p className="tool-words" role="status">
        {wrong === undefined
          ? t("A line changes a variable or adds one; a line that is taken away changes nothing.")
          : t("This sets no variable: {0}", wrong)}
      </p>
      <div className="variable-tools">
        <Button onPress={onDone}>Cancel</Button>
        <Button
          look="primary"
          refused={wrong && t("This sets no variable: {0}", wrong)}
          onPress={() => void save()}
        >
          Save
        </Button>
      </div>
    </div>
  );
}
