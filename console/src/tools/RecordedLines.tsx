import { ListBox, ListBoxItem } from "react-aria-components";
import { Tail } from "../ui/Tail";
import { t } from "../words/words";

interface RecordedLinesProps {
  lines: readonly string[];
  onRun: (line: string) => void;
}

/** Recorded lines, the newest last: a double click or Enter runs one again. */
export function RecordedLines({ lines, onRun }: RecordedLinesProps) {
  return (
    <Tail label={t("Recorded lines")} empty={t("Nothing is recorded yet.")} count={lines.length}>
      <ListBox
        aria-label={t("Recorded commands")}
        className="recorder-list"
        selectionMode="single"
        selectionBehavior="replace"
        onAction={(key) => {
          const line = lines[Number(key)];
          if (line !== undefined) onRun(line);
        }}
      >
        {lines.map((line, n) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: the same line may be there twice
          <ListBoxItem key={n} id={String(n)} className="recorder-line list-row" textValue={line}>
            <code>{line}</code>
          </ListBoxItem>
        ))}
      </ListBox>
    </Tail>
  );
}
