import { useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useShown, worldOf } from "../app/context";
import { refusal } from "../keypad/useMayMove";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import "./tools.css";

const key = "kerf.scratch";

/** The scratch pad (SI): lines of OpenSBP and G-code, run as a small program. */
export function ScratchSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const [text, setText] = useState(() => localStorage.getItem(key) ?? "");
  const refused = useShown(refusal);
  const write = (next: string) => {
    localStorage.setItem(key, next);
    setText(next);
  };
  return (
    <Sheet
      title="Scratch pad"
      onClose={onClose}
      foot={
        <>
          <span className="scratch-refused">{refused}</span>
          <Button onPress={() => write("")}>Empty</Button>
          <Button
            look="go"
            isDisabled={refused !== undefined || text.trim() === ""}
            onPress={() => void drive(worldOf(hands), { do: "command", line: text })}
          >
            Run
          </Button>
        </>
      }
    >
      <textarea
        className="scratch"
        aria-label="Lines to run"
        data-first
        rows={10}
        spellCheck={false}
        placeholder={"J2, 0, 0\nMZ, -0.1\nG1 X2 F60"}
        value={text}
        onChange={(event) => write(event.target.value)}
      />
    </Sheet>
  );
}
