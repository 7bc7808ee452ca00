import { ask, drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { type Entries, fileParameters } from "./sheet";

interface FileButtonsProps {
  /** The line that the sheet makes: `FP,part.sbp,2`. */
  line: string;
  entries: Entries;
  onDone: () => void;
}

/** Buttons for a file beside the cut: to look at it, to go through it line by line. */
export function FileButtons({ line, entries, onDone }: FileButtonsProps) {
  const hands = useHands();
  const name = (entries[0] ?? "").trim();
  const folder = useSnapshot("folder")?.name ?? "";
  const unit = useLengthUnit();
  const preview = async () => {
    const below = folder === "" ? name : `${folder}/${name}`;
    const parameters = fileParameters(entries, unit);
    if (await ask(worldOf(hands), { do: "open", name: below, parameters })) onDone();
  };
  const step = async () => {
    const stepped = line.replace(/^FP/, "FG");
    if (await drive(worldOf(hands), { do: "command", line: stepped })) onDone();
  };
  return (
    <>
      <Button
        refused={name === "" ? t("Choose a file first.") : undefined}
        onPress={() => void preview()}
      >
        Preview
      </Button>
      <Button
        refused={name === "" ? t("Choose a file first.") : undefined}
        onPress={() => void step()}
      >
        Single step
      </Button>
    </>
  );
}
