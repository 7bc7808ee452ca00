import { command } from "../actions/machine";
import { useSnapshot } from "../app/context";
import { speedText } from "../app/units";
import { ActionButton } from "../ui/ActionButton";
import { Panel } from "../ui/Panel";
import type { Speeds, Units } from "../wire/wire";
import "./status-panel.css";

const absolute = command("machine.absolute", "Absolute", "SA");
const relative = command("machine.relative", "Relative", "SR");

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
              Now
            </th>
          </tr>
        </thead>
        <tbody>
          <SpeedRow title="Move" speeds={speeds.cut} units={units} now={motion.speed} />
          <SpeedRow title="Jog" speeds={speeds.jog} units={units} />
        </tbody>
      </table>
    </Panel>
  );
}

function DistanceMode({ absolute: on }: { absolute: boolean }) {
  return (
    <span className="status-mode">
      {on ? "Absolute" : "Relative"}
      <ActionButton action={on ? relative : absolute} look="quiet" size="small">
        {on ? "to relative" : "to absolute"}
      </ActionButton>
    </span>
  );
}

interface SpeedRowProps {
  title: string;
  speeds: Speeds["cut"];
  units: Units;
  now?: number;
}

function SpeedRow({ title, speeds, units, now }: SpeedRowProps) {
  return (
    <tr>
      <th scope="row">{title}</th>
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
