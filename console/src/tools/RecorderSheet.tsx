import { useState } from "react";
import { drive } from "../actions/ask";
import { command, modeOf } from "../actions/machine";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { phrase, t } from "../words/words";
import { RecordedLines } from "./RecordedLines";
import "./tools.css";

const playAll = command("recorder.all", t("Play all (RP)"), "RP");
const on = modeOf("recorder.on", t("Record (RA)"), "RA");
const off = modeOf("recorder.off", t("Do not record (RI)"), "RI");
const empty = modeOf("recorder.empty", t("Empty the list (RZ)"), "RZ");

/** Lists the recorded commands, to be run again and to be kept as a part file: RA, RI, RP, RR, RS, RZ. */
export function RecorderSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const recorder = useSnapshot("recorder");
  const [back, setBack] = useState("");
  const [times, setTimes] = useState("1");
  const [name, setName] = useState("");
  const run = (line: string) => void drive(worldOf(hands), { do: "command", line });
  if (!recorder) return null;
  return (
    <Sheet
      title="Recorded commands"
      shape="side"
      onClose={onClose}
      foot={
        <>
          <ActionButton action={empty} look="quiet" />
          <ActionButton action={recorder.on ? off : on} />
          <ActionButton action={playAll} look="go" />
        </>
      }
    >
      <p className="tool-words">
        {phrase(
          "{0} {1} A double click runs a line again.",
          <RecorderMark />,
          recorder.on ? t("What is typed is recorded.") : t("Nothing is recorded now."),
        )}
      </p>
      <RecordedLines lines={recorder.lines} onRun={run} />
      <form
        className="recorder-form"
        onSubmit={(event) => {
          event.preventDefault();
          run(`RR,${back.trim() || 1},${times.trim() || 1}`);
        }}
      >
        <Field label="Commands back" value={back} onChange={setBack} placeholder="1" />
        <Field label="Times" value={times} onChange={setTimes} />
        <Button type="submit">Replay</Button>
      </form>
      <form
        className="recorder-form"
        onSubmit={(event) => {
          event.preventDefault();
          if (name.trim()) run(`RS,${name.trim()}`);
        }}
      >
        <Field label="Part file" value={name} onChange={setName} placeholder="recorded.sbp" />
        <Button type="submit" refused={name.trim() === "" ? t("Enter a name first.") : undefined}>
          Save
        </Button>
      </form>
    </Sheet>
  );
}

/** A full dot while commands are recorded, an open circle while they are not. */
export function RecorderMark() {
  const on = useSnapshot("recorder")?.on;
  const words = on ? t("Commands are recorded") : t("Commands are not recorded");
  return (
    <span className={`recorder-mark recorder-${on ? "on" : "off"}`} role="img" aria-label={words} />
  );
}
