import { useHands, useShown, useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";
import type { Lamp } from "../wire/messages";
import "./lamps.css";

/** The inputs and outputs of the machine. */
export function Lamps() {
  const io = useSnapshot("io");
  if (!io) return null;
  return (
    <Panel title="Inputs and outputs" className="lamps">
      <Row title="In" word="Input" lamps={io.inputs} />
      <Row title="Out" word="Output" lamps={io.outputs} />
    </Panel>
  );
}

function Row({ title, word, lamps }: { title: string; word: string; lamps: readonly Lamp[] }) {
  const { screen } = useHands();
  const simulated = useShown((shown) => shown.snapshot?.machine.mode !== "cut");
  return (
    <div className="lamps-row">
      {word === "Input" && simulated ? (
        <button
          type="button"
          className="lamps-press"
          title="Move the switches of the simulated machine"
          onClick={() => screen.open({ kind: "inputs" })}
        >
          {title}
        </button>
      ) : (
        <h3>{title}</h3>
      )}
      <ol>
        {lamps.map((lamp) => (
          <li
            key={lamp.number}
            className={lamp.on ? "lamp lamp-on" : "lamp"}
            title={lamp.label || `${word} ${lamp.number}`}
          >
            <span aria-hidden="true">{lamp.number}</span>
            <span className="hidden-text">
              {word} {lamp.number} {lamp.label} is {lamp.on ? "on" : "off"}
            </span>
          </li>
        ))}
      </ol>
    </div>
  );
}
