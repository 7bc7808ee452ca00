import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Pick } from "../ui/Pick";

const percents = (shares: readonly number[]) =>
  shares.map((share) => ({ value: `${share}`, words: `${share} %` }));

const rapids = percents([25, 50, 100]);
const spindles = percents([50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150]);

/** The shares of rapid moves and of the spindle, where the machine overrides them by itself. */
export function MachineOverrides() {
  const hands = useHands();
  const overrides = useSnapshot("overrides");
  const { rapidPercent = null, spindlePercent = null } = overrides ?? {};
  if (rapidPercent === null || spindlePercent === null) return null;
  const world = () => worldOf(hands);
  return (
    <div className="job-overrides">
      <Pick
        label="Rapids"
        options={rapids}
        value={`${rapidPercent}`}
        onChange={(of) => void drive(world(), { do: "override", rapidPercent: Number(of) })}
        labelled
      />
      <Pick
        label="Spindle"
        options={spindles}
        value={`${spindlePercent}`}
        onChange={(of) => void drive(world(), { do: "override", spindlePercent: Number(of) })}
        labelled
      />
    </div>
  );
}
