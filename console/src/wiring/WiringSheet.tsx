import { useState } from "react";
import { drive } from "../actions/ask";
import { unlessReady } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Pick } from "../ui/Pick";
import { Sheet } from "../ui/Sheet";
import type { Wiring } from "../wire/messages";
import { serverWords } from "../words/server";
import { t } from "../words/words";
import { Ports } from "./Ports";
import { Switches } from "./Switches";
import { steps } from "./steps";
import "./wiring.css";

/**
 * Wires a board with step queues: pins, then each motor, switch and output is looked at, then speeds are tried. What is
 * told is in millimetres, as the questions are.
 */
export function WiringSheet({ onClose }: { onClose: () => void }) {
  const { link, screen } = useHands();
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const wiring = useSnapshot("wiring");
  return (
    <Sheet title={t("Wire a board")} shape="side" onClose={onClose}>
      {wiring?.isOpen ? (
        <>
          <Asked key={wiring.question} wiring={wiring} refused={refused} />
          <Switches switches={wiring.switches} />
        </>
      ) : (
        <Begin wiring={wiring ?? null} refused={refused} />
      )}
    </Sheet>
  );
}

interface BeginProps {
  wiring: Wiring | null;
  refused: string | undefined;
}

function Begin({ wiring, refused }: BeginProps) {
  const hands = useHands();
  const [port, setPort] = useState("/dev/ttyACM0");
  const [board, setBoard] = useState("");
  const [into, setInto] = useState("mine.toml");
  const named = board.trim() === "" ? {} : { board: board.trim() };
  const begin = () => void drive(worldOf(hands), { do: "wire", port, into, ...named });
  const look = () => void drive(worldOf(hands), { do: "wireLook", port });
  const { ended = null, isLooking = false, found = [] } = wiring ?? {};
  const mayBe = found.find((it) => it.port === port)?.board?.mayBe ?? [];
  return (
    <div className="wiring-entry">
      {ended !== null && (
        <p className="wiring-told" role="status">
          {serverWords(ended)}
        </p>
      )}
      <p className="wiring-words">
        {t(
          "A board with Klipper's firmware becomes the controller of this machine. Motors turn 1 mm: have their shafts free, the spindle unplugged, and a hand at the switch of the supply. STOP ends it at once.",
        )}
      </p>
      <Ports found={found} port={port} onChoose={setPort} />
      {isLooking && <p role="status">{t("Ports are looked at …")}</p>}
      <Button refused={isLooking ? t("Ports are looked at …") : refused} onPress={look}>
        Look for boards
      </Button>
      <Field
        label="Port of the board"
        value={port}
        onChange={setPort}
        isRequired
        first
        hint="Looking opens each port for a moment: a device that begins anew when its port is opened does so."
      />
      {mayBe.length > 0 ? (
        <Pick
          label="Board that is sold"
          labelled
          options={[
            { value: "", words: "Another one: its pins are asked for" },
            ...mayBe.map(({ name, title }) => ({ value: name, words: title })),
          ]}
          value={board}
          onChange={setBoard}
        />
      ) : (
        <Field
          label="Board that is sold"
          value={board}
          onChange={setBoard}
          hint="Its pins are known: skr-pico, octopus-1.1 … kerf machine boards lists them."
        />
      )}
      <Field label="File of the machine" value={into} onChange={setInto} isRequired />
      <Button
        look="primary"
        refused={isLooking ? t("Ports are looked at …") : refused}
        onPress={begin}
      >
        Begin
      </Button>
    </div>
  );
}

interface AskedProps {
  wiring: Wiring;
  refused: string | undefined;
}

function Asked({ wiring, refused }: AskedProps) {
  const hands = useHands();
  const [entry, setEntry] = useState(wiring.value);
  const step = wiring.step === null ? undefined : steps[wiring.step];
  const give = (answer: string) =>
    void drive(worldOf(hands), { do: "wireAnswer", question: wiring.question, answer });
  return (
    <>
      {wiring.told.map((words) => (
        <p className="wiring-told" role="status" key={words}>
          {serverWords(words)}
        </p>
      ))}
      {step ? (
        <section className="wiring-asked" aria-label={t("Question")}>
          <p className="wiring-question">{step.ask(wiring.about, wiring.value)}</p>
          <div className="wiring-choices">
            {step.choices.map(({ answer, words }, n) => (
              <Button
                key={words}
                look={n === 0 ? "primary" : "plain"}
                refused={refused}
                onPress={() => give(answer)}
              >
                {words}
              </Button>
            ))}
          </div>
          {step.entry && (
            <form
              className="wiring-entry"
              onSubmit={(event) => {
                event.preventDefault();
                give(entry);
              }}
            >
              <Field
                label={step.entry}
                value={entry}
                onChange={setEntry}
                hint={step.hint}
                first={step.choices.length === 0}
              />
              <Button type="submit" refused={refused}>
                Next
              </Button>
            </form>
          )}
        </section>
      ) : (
        <p className="wiring-words" role="status">
          {t("The board is at work …")}
        </p>
      )}
      <Button look="quiet" onPress={() => give("q")}>
        End without writing
      </Button>
    </>
  );
}
