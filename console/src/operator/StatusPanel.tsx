import { attempt } from "../actions/action";
import { modeOf } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { speedText } from "../app/units";
import { MapStatus } from "../heightmap/MapStatus";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import type { MmPerS } from "../units/quantity";
import type { Speeds, Units } from "../wire/messages";
import { t } from "../words/words";
import "./status-panel.css";

const absolute = modeOf("machine.absolute", t("Absolute"), "SA");
const relative = modeOf("machine.relative", t("Relative"), "SR");

/** Distance mode, units, speeds in force. */
export function StatusPanel() {
  const units = useSnapshot("units");
  const speeds = useSnapshot("speeds");
  const motion = useSnapshot("motion");
  if (!units || !speeds || !motion) return null;
  return (
    <Panel title="Speeds" className="status" aside={<DistanceMode absolute={units.absolute} />}>
      <table className="status-speeds">
        <thead>
          <tr>
            <td />
            <th scope="col">XY</th>
            <th scope="col">Z</th>
            <th scope="col" className="status-now-head">
              {t("Now")}
            </th>
          </tr>
        </thead>
        <tbody>
          <SpeedRow
            title={t("Move")}
            letters="MS"
            speeds={speeds.cutMmS}
            units={units}
            now={motion.speedMmS}
          />
          <SpeedRow title={t("Jog")} letters="JS" speeds={speeds.jogMmS} units={units} />
        </tbody>
      </table>
      <MapStatus />
    </Panel>
  );
}

const distances = [
  { value: "absolute", words: "Absolute", action: absolute },
  { value: "relative", words: "Relative", action: relative },
] as const;

/** Switches the numbers of moves between places and distances. */
function DistanceMode({ absolute: on }: { absolute: boolean }) {
  const hands = useHands();
  const ready = useShown((shown) => shown.snapshot?.machine.state === "idle");
  return (
    <Choice
      label="Distances"
      options={distances}
      value={on ? "absolute" : "relative"}
      isDisabled={!ready}
      onChange={(value) => {
        const chosen = distances.find((distance) => distance.value === value);
        if (chosen) attempt(chosen.action, worldOf(hands));
      }}
    />
  );
}

interface SpeedRowProps {
  title: string;
  /** The command that changes them. */
  letters: string;
  speeds: Speeds["cutMmS"];
  units: Units;
  now?: MmPerS;
}

function SpeedRow({ title, letters, speeds, units, now }: SpeedRowProps) {
  const { screen } = useHands();
  return (
    <tr>
      <th scope="row">
        <button
          type="button"
          className="status-change"
          title={t("Change the {0} speeds ({1})", title.toLowerCase(), letters)}
          onClick={() => screen.open({ kind: "command", letters, given: [] })}
        >
          {title}
        </button>
      </th>
      <td>{speedText(speeds[0], units)}</td>
      <td>{speedText(speeds[1], units)}</td>
      {now !== undefined && (
        <td className="status-now" rowSpan={2}>
          <output>{speedText(now, units)}</output>
          <small>{units.linear}/s</small>
        </td>
      )}
    </tr>
  );
}
