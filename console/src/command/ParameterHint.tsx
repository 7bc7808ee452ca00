import { Button } from "../ui/Button";
import type { CommandEntry } from "../wire/messages";
import { parameterWords } from "../words/commands";
import { t } from "../words/words";
import { parameterAt } from "./line";

interface ParameterHintProps {
  text: string;
  entry: CommandEntry | undefined;
  table: readonly CommandEntry[];
  onSheet: (entry: CommandEntry, text: string) => void;
}

/**
 * Lists the parameters of a command in order and marks the one being written; before that, the commands of
 * a letter.
 */
export function ParameterHint({ text, entry, table, onSheet }: ParameterHintProps) {
  if (!entry) return <Following letter={text.trim()} table={table} />;
  const now = parameterAt(entry, text);
  return (
    <div className="hint" role="status">
      <strong className="hint-name">
        {entry.letters} {entry.name}
      </strong>
      <ol className="hint-parameters">
        {entry.parameters.map((parameter) => (
          <li key={parameter.name} className={parameter === now ? "hint-now" : ""}>
            {parameterWords(parameter.name)}
            {parameter.required && "*"}
          </li>
        ))}
      </ol>
      <span className="hint-doc">{now?.doc || entry.doc}</span>
      {entry.parameters.length > 0 && (
        <Button size="small" onPress={() => onSheet(entry, text)}>
          Fill-in sheet
        </Button>
      )}
    </div>
  );
}

/** The commands that begin with a letter. */
function Following({ letter, table }: { letter: string; table: readonly CommandEntry[] }) {
  const following =
    letter.length === 1 ? table.filter((e) => e.letters.startsWith(letter.toUpperCase())) : [];
  return (
    <div className="hint" role="status">
      {following.length > 0 ? (
        <ol className="hint-parameters">
          {following.map((entry) => (
            <li key={entry.letters}>
              <b>{entry.letters}</b> {entry.name}
            </li>
          ))}
        </ol>
      ) : (
        <span className="hint-doc">
          {t(
            "Type two letters, then parameters. ↑ recalls, Esc clears, K is the keypad, I the scratch pad.",
          )}
        </span>
      )}
    </div>
  );
}
