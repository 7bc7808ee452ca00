import { drive } from "../actions/ask";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { lengthText } from "../app/units";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import { choose } from "./actions";
import type { Plan } from "./plan";
import { ValueField } from "./ValueField";

const yesNo = [
  { value: "yes", words: "Yes" },
  { value: "no", words: "No" },
] as const;

/** What the job is cut with: looked at, and changed, before the start. */
export function CutPanel({ plan }: { plan: Plan }) {
  const hands = useHands();
  const units = useSnapshot("units");
  const offset = useSnapshot("opened")?.choice.offset ?? 0;
  const inForce = useSnapshot("job")?.heights;
  const idle = useShown((shown) => shown.snapshot?.machine.state === "idle");
  const runs = useShown((shown) => shown.snapshot?.job?.ended === null);
  if (!units) return null;
  const { view } = plan;
  const [top, surface, bottom] = (runs && inForce) || view.heights;
  const set = (key: string, value: string) => drive(worldOf(hands), { do: "set", key, value });
  const { mm, linear } = units;
  const speed = (key: string) => (value: number) => set(key, `${value * mm} mm/min`);
  const height = (key: string) => (value: number) => set(key, String(value * mm));
  const off = !idle;
  const perMin = `${linear}/min`;
  return (
    <Panel title="How it is cut" className="cut-panel">
      <div className="cut-grid">
        <ValueField
          label="Cutting speed"
          value={(view.cutMmS * 60) / mm}
          unit={perMin}
          isDisabled={off}
          onSet={speed("smoothing.cut_speed_mm_s")}
        />
        <ValueField
          label="Plunging speed"
          value={(view.plungeMmS * 60) / mm}
          unit={perMin}
          isDisabled={off}
          onSet={speed("plunge.speed_mm_s")}
        />
        <ValueField
          label="Z top"
          value={top / mm}
          unit={linear}
          isDisabled={off}
          onSet={height("zpos.top_mm")}
        />
        <ValueField
          label="Z surface"
          value={surface / mm}
          unit={linear}
          isDisabled={off}
          onSet={height("zpos.surface_mm")}
        />
        <ValueField
          label="Z bottom"
          value={bottom / mm}
          unit={linear}
          isDisabled={off}
          onSet={height("zpos.bottom_mm")}
        />
        <ValueField
          label="Repeats"
          value={view.repeats}
          isDisabled={off}
          onSet={(value) => set("job.repeats", String(value))}
        />
        <ValueField
          label="Offset of all paths"
          value={offset / mm}
          unit={linear}
          isDisabled={off}
          onSet={(value) => choose(worldOf(hands), { offset: value * mm })}
        />
        <div className="field">
          <span className="field-label">Rises when paused</span>
          <Choice
            label="Rises when paused"
            options={yesNo}
            value={view.raise ? "yes" : "no"}
            isDisabled={off}
            onChange={(value) => void set("pause.raise", value === "yes" ? "true" : "false")}
          />
        </div>
      </div>
      <Origin plan={plan} isDisabled={off} />
      <p className="cut-finish">
        At the end the head goes to {lengthText(view.finish[0], units)},{" "}
        {lengthText(view.finish[1], units)} from the origin.
      </p>
    </Panel>
  );
}

/** Where the job lies on the table. */
function Origin({ plan, isDisabled }: { plan: Plan; isDisabled: boolean }) {
  const hands = useHands();
  const units = useSnapshot("units");
  const at = useSnapshot("motion")?.at.machine;
  const chosen = useSnapshot("opened")?.choice.origin ?? null;
  if (!units || !at) return null;
  const [x, y] = plan.view.origin;
  return (
    <div className="cut-origin">
      <p>
        <span className="field-label">Origin from home</span>
        <b>
          {lengthText(x, units)}, {lengthText(y, units)}
        </b>
      </p>
      {plan.view.originAtStart ? (
        <p>Each start takes the present place.</p>
      ) : (
        <>
          <Button
            size="small"
            isDisabled={isDisabled}
            onPress={() => void choose(worldOf(hands), { origin: [at[0], at[1]] })}
          >
            Set it here
          </Button>
          <Button
            size="small"
            isDisabled={isDisabled || chosen === null}
            onPress={() => void choose(worldOf(hands), { origin: null })}
          >
            As in the file
          </Button>
        </>
      )}
    </div>
  );
}
