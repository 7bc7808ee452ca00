import { ask, drive } from "../actions/ask";
import { useHands, worldOf } from "../app/context";
import { Button } from "../ui/Button";

interface FileButtonsProps {
  /** The line that the sheet makes: `FP,part.sbp,2`. */
  line: string;
  file: string;
  onDone: () => void;
}

/** What else can be done with a file than to cut it: look at it, go through it line by line. */
export function FileButtons({ line, file, onDone }: FileButtonsProps) {
  const hands = useHands();
  const name = file.trim();
  const preview = async () => {
    if (await ask(worldOf(hands), { do: "open", name })) onDone();
  };
  const step = async () => {
    const stepped = line.replace(/^FP/, "FG");
    if (await drive(worldOf(hands), { do: "command", line: stepped })) onDone();
  };
  return (
    <>
      <Button isDisabled={name === ""} onPress={() => void preview()}>
        Preview
      </Button>
      <Button isDisabled={name === ""} onPress={() => void step()}>
        Single step
      </Button>
    </>
  );
}
