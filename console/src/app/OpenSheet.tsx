import { FilePicker } from "../operator/FilePicker";
import type { Sheet } from "./screen";

/** The sheet that is open. */
export function OpenSheet({ sheet }: { sheet: Sheet }) {
  switch (sheet.kind) {
    case "files":
      return <FilePicker />;
    default:
      return null;
  }
}
