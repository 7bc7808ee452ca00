import { useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { lengthText } from "../app/units";
import { useAside } from "../operator/useAside";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Sheet } from "../ui/Sheet";
import type { Asked } from "../wire/messages";
import { useJob } from "./useJob";
import { ValueField } from "./ValueField";
import "./job-screen.css";

/**
 * A job that waits: before its start, at a pause mark, or because something stopped it. The tool can be
 * moved, speeds and ZBottom changed; cutting goes on at the very place.
 */
export function PausedDialog({ asked }: { asked: Asked }) {
  const hands = useHands();
  const { sheet, buttons } = useAside(["keypad", "inputs"]);
  const say = (words: string) =>
    ask(worldOf(hands), { do: "answer", question: asked.number, answer: words });
  if (sheet) return sheet;
  const chooses = asked.text.startsWith("Start with shape");
  const [goesOn = "Resume", ends = "Quit"] = asked.buttons;
  return (
    <Sheet
      title={asked.text || asked.title}
      shape="side"
      foot={
        <>
          <Button size="large" onPress={() => void say(ends)}>
            {ends}
          </Button>
          <Button size="large" look="go" autoFocus onPress={() => void say(goesOn)}>
            {chooses ? "Start" : goesOn}
          </Button>
        </>
      }
    >
      <div className="paused">
        <div className="paused-hands">{buttons}</div>
        {chooses ? <ChooseStart text={asked.text} say={say} /> : <ChangeValues say={say} />}
      </div>
    </Sheet>
  );
}

interface Says {
  say: (words: string) => Promise<boolean>;
}

/** The path with which the job begins, before its second Start. */
function ChooseStart({ text, say }: Says & { text: string }) {
  const number = Number(/\d+/.exec(text)?.[0] ?? 1);
  return (
    <>
      <p>The head stands over the beginning of path {number}. Start cuts from there.</p>
      <div className="start-choice">
        <ValueField
          label="Begins with path"
          value={number}
          onSet={(value) => say(String(Math.max(1, Math.round(value))))}
        />
        <Button aria-label="The path before" onPress={() => void say("previous")}>
          −
        </Button>
        <Button aria-label="The next path" onPress={() => void say("next")}>
          +
        </Button>
      </div>
    </>
  );
}

/** Speeds and heights of the rest of the job. */
function ChangeValues({ say }: Says) {
  const plan = useJob();
  const units = useSnapshot("units");
  const heights = useSnapshot("job")?.heights;
  // What was said holds until the job is over; the server keeps the configuration as it was.
  const [said, setSaid] = useState<{ cut?: number; plunge?: number; raise?: boolean }>({});
  if (!plan || !units) return null;
  const { mm, linear } = units;
  const { view } = plan;
  const raise = said.raise ?? view.raise;
  const mmMin = (which: "cut" | "plunge") => async (value: number) => {
    const done = await say(`${which} ${value * mm}`);
    if (done) setSaid((now) => ({ ...now, [which]: value * mm }));
    return done;
  };
  return (
    <>
      <p>
        The tool goes back to where the cut was left by itself, however far it is moved. What is
        changed here holds for the rest of the job.
      </p>
      <div className="cut-grid">
        <ValueField
          label="Cutting speed"
          value={(said.cut ?? view.cutMmS * 60) / mm}
          unit={`${linear}/min`}
          onSet={mmMin("cut")}
        />
        <ValueField
          label="Plunging speed"
          value={(said.plunge ?? view.plungeMmS * 60) / mm}
          unit={`${linear}/min`}
          onSet={mmMin("plunge")}
        />
        <ValueField
          label="Move Z bottom by"
          value={0}
          unit={linear}
          onSet={async (value) => {
            await say(`zbottom ${value * mm}`);
            // What was asked for is done: the field is ready for the next change.
            return false;
          }}
        />
        <div className="field">
          <span className="field-label">Rises when paused</span>
          <Choice
            label="Rises when paused"
            options={[
              { value: "yes", words: "Yes" },
              { value: "no", words: "No" },
            ]}
            value={raise ? "yes" : "no"}
            onChange={async (value) => {
              if (await say(`raise ${value}`))
                setSaid((now) => ({ ...now, raise: value === "yes" }));
            }}
          />
        </div>
      </div>
      {heights && (
        <p className="paused-heights">
          Z top {lengthText(heights[0], units)}, surface {lengthText(heights[1], units)}, bottom{" "}
          <b>{lengthText(heights[2], units)}</b>
        </p>
      )}
    </>
  );
}
