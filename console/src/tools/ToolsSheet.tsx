import { useHands } from "../app/context";
import { inMenu, useCommands } from "../command/table";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import "./tools.css";

/** The virtual tools: each asks what it needs and makes a part file. */
export function ToolsSheet({ onClose }: { onClose: () => void }) {
  const { screen } = useHands();
  const table = useCommands();
  return (
    <Sheet title="Virtual tools" onClose={onClose}>
      <p className="tool-words">{t("Each asks what it needs, and makes a part file of it.")}</p>
      <ul className="virtual-tools">
        {inMenu(table, "tools").map(({ letters, name, doc }) => (
          <li key={letters}>
            <Button onPress={() => screen.open({ kind: "command", letters, given: [] })}>
              <b>{letters}</b> {t(name)}
            </Button>
            <span>{t(doc)}</span>
          </li>
        ))}
      </ul>
    </Sheet>
  );
}
