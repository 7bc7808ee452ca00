import { ask, drive } from "../actions/ask";
import { openMoveTo } from "../actions/go";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { placeText } from "../app/units";
import { useBusy } from "../app/useBusy";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import { type Mm, type MmPerMin, mm } from "../units/quantity";
import { t } from "../words/words";
import { choose } from "./actions";
import type { Plan } from "./plan";
import { lengthField, speedField, ValueField, type ValueFieldProps } from "./ValueField";

const yesNo = [
  { value: "yes", words: "Yes" },
  { value: "no", words: "No" },
] as const;

/** Settings with which the job is cut: to be read, and changed, before the start. */
export function CutPanel({ plan }: { plan: Plan }) {
  const hands = useHands();
  const units = useSnapshot("units");
  const offset = useSnapshot("opened")?.choice.offset ?? mm(0);
  const job = useSnapshot("job");
  const busy = useBusy();
  if (!units) return null;
  const { view } = plan;
  const runs = job?.ended === null ? job : null;
  const [top, surface, bottom] = runs?.heights ?? view.heights;
  const { cutMmS, plungeMmS, raise } = runs?.inForce ?? view;
  const set = (key: string, value: string) => drive(worldOf(hands), { do: "set", key, value });
  const speed = (key: string) => (value: MmPerMin) => set(key, `${value} mm/min`);
  const height = (key: string) => (value: Mm) => set(key, String(value));
  const off = busy !== undefined;
  const fields: readonly ValueFieldProps[] = [
    speedField(t("Cutting speed"), cutMmS, units, speed("smoothing.cut_speed_mm_s")),
    speedField(t("Plunging speed"), plungeMmS, units, speed("plunge.speed_mm_s")),
    lengthField(t("Z top"), top, units, height("zpos.top_mm")),
    lengthField(t("Z surface"), surface, units, height("zpos.surface_mm")),
    lengthField(t("Z bottom"), bottom, units, height("zpos.bottom_mm")),
    {
      label: t("Repeats"),
      value: view.repeats,
      onSet: (value) => set("job.repeats", String(value)),
    },
    lengthField(t("Offset of all paths"), offset, units, (offset) =>
      choose(worldOf(hands), { offset }),
    ),
  ];
  return (
    <Panel title="How it is cut" className="cut-panel">
      <div className="cut-grid">
        {fields.map((field) => (
          <ValueField key={field.label} {...field} isDisabled={off} />
        ))}
        <div className="field">
          <span className="field-label">{t("Rises when paused")}</span>
          <Choice
            label="Rises when paused"
            options={yesNo}
            value={raise ? "yes" : "no"}
            isDisabled={off}
            onChange={(value) => void set("pause.raise", value === "yes" ? "true" : "false")}
          />
        </div>
      </div>
      <Origin plan={plan} busy={busy} />
      <NotHomed />
      <div className="cut-origin">
        <ActionButton action={openMoveTo} size="small">
          Move to…
        </ActionButton>
      </div>
      <p className="cut-finish">
        {t("At the end the head goes to {0} from the origin.", placeText(view.finish, units))}
      </p>
    </Panel>
  );
}

/** Tells which axes have a home switch and were not homed: nobody knows where on the table their places are. */
function NotHomed() {
  const axes = useSnapshot("setup")?.notHomed ?? "";
  if (axes === "") return null;
  return (
    <p className="cut-warning">
      {t(
        "Not homed: {0}. The origin and the bounds of the table hold from where the machine was switched on, until these axes are homed.",
        [...axes].join(", "),
      )}
    </p>
  );
}

/** Place of the job on the table. */
function Origin({ plan, busy }: { plan: Plan; busy: string | undefined }) {
  const hands = useHands();
  const units = useSnapshot("units");
  const at = useSnapshot("motion")?.at.machine;
  const chosen = useSnapshot("opened")?.choice.origin ?? null;
  const own = chosen ? undefined : t("It lies where its file says.");
  if (!units || !at) return null;
  return (
    <div className="cut-origin">
      <p>
        <span className="field-label">{t("Origin from home")}</span>
        <b>{placeText(plan.view.origin, units)}</b>
      </p>
      {plan.view.originAtStart ? (
        <p>{t("Each start takes the present place.")}</p>
      ) : (
        <>
          <Button
            size="small"
            refused={busy}
            onPress={() => void choose(worldOf(hands), { origin: [at[0], at[1]] })}
          >
            Set it here
          </Button>
          <Button
            size="small"
            refused={busy ?? own}
            onPress={() => void choose(worldOf(hands), { origin: null })}
          >
            As in the file
          </Button>
          <Button
            size="small"
            refused={busy ?? own}
            onPress={() => void ask(worldOf(hands), { do: "keepOrigin" })}
          >
            Keep it in the file
          </Button>
        </>
      )}
    </div>
  );
}
