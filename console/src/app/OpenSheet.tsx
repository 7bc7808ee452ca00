import { CommandSheet } from "../command/CommandSheet";
import { KeypadSheet } from "../keypad/KeypadSheet";
import { FilePicker } from "../operator/FilePicker";
import { useHands } from "./context";
import type { Sheet } from "./screen";

/** The sheet that is open. */
export function OpenSheet({ sheet }: { sheet: Sheet }) {
  const { screen } = useHands();
  const close = () => screen.open(null);
  switch (sheet.kind) {
    case "files":
      return <FilePicker />;
    case "command":
      return <CommandSheet letters={sheet.letters} given={sheet.given} />;
    case "keypad":
      return <KeypadSheet onClose={close} />;
    default:
      return null;
  }
}
