import { useState } from "react";
import { useHands } from "../app/context";
import { lengthOf } from "../app/expression";
import { shortText } from "../app/units";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { mm } from "../units/quantity";
import type { SettingArea } from "../wire/messages";
import { phrase, t } from "../words/words";
import { useSet } from "./SettingValue";
import { keepSetUp } from "./setUp";
import { TopicTables } from "./TopicTables";
import { partsOf, topicOf } from "./tables";
import { useSettings } from "./useSettings";

interface Step {
  readonly title: string;
  readonly words: string;
  /** The settings that are asked for; an area's where it ends with a dot. */
  readonly keys: readonly string[];
}

/** The steps of setting up a machine, in order. */
const steps: readonly Step[] = [
  {
    title: t("Units"),
    words: "Lengths are read and typed in this unit from now on, also in the next questions.",
    keys: ["units"],
  },
  {
    title: t("Axes"),
    words: "Three axes are X, Y and Z. A fourth is A: a second head, or an axis that turns.",
    keys: ["axes", "rotary"],
  },
  {
    title: t("Table size"),
    words:
      "How far X and Y reach from the corner at zero, and how far Z goes up and down from its zero.",
    keys: [],
  },
  {
    title: t("Limits"),
    words: "With the check on, a program that leaves the table is refused before it starts.",
    keys: ["limits."],
  },
  {
    title: t("Spindle"),
    words:
      "Does the operator switch the spindle on, or does Kerf? The height is where the tool travels above the work.",
    keys: ["ask_spindle", "spindle_device", "cutter.safe_z_mm", "cutter.diameter_mm"],
  },
  {
    title: t("What is wired"),
    words:
      "Switches: 0 is a plain input, 1 and 2 are limit switches, 3 and 4 stop the machine. Homing: which axes have a switch. An emergency stop that cuts the power is wired, never software alone.",
    keys: [
      "io.limits_active",
      "io.input4_normally_open",
      "io.inputs",
      "homing.x.fitted",
      "homing.y.fitted",
      "homing.z.fitted",
    ],
  },
];

/** Asks for what a new machine needs: a step at a time, each answer holds at once. */
export function SetupSheet({ onClose }: { onClose: () => void }) {
  const areas = useSettings();
  const { screen } = useHands();
  const [at, setAt] = useState(0);
  const step = steps[at] ?? steps[0];
  if (!step) return null;
  const isLast = at === steps.length - 1;
  const end = () => {
    keepSetUp().catch((error: Error) => screen.tell(error.message));
    onClose();
  };
  const foot = (
    <>
      <Button look="quiet" onPress={end}>
        Skip
      </Button>
      <Button
        refused={at === 0 ? t("This is the first step.") : undefined}
        onPress={() => setAt(at - 1)}
      >
        Back
      </Button>
      <Button look="primary" onPress={() => (isLast ? end() : setAt(at + 1))}>
        {isLast ? t("Done") : t("Next")}
      </Button>
    </>
  );
  return (
    <Sheet title="Set up the machine" shape="wide" onClose={end} foot={foot}>
      <p className="setup-steps">
        {phrase("Step {0} of {1}: {2}", at + 1, steps.length, <b>{t(step.title)}</b>)}
      </p>
      <p className="tool-words">{t(step.words)}</p>
      {step.keys.length === 0 ? <TableSize areas={areas} /> : <Asked areas={areas} step={step} />}
    </Sheet>
  );
}

function Asked({ areas, step }: { areas: readonly SettingArea[]; step: Step }) {
  const isAsked = (key: string) =>
    step.keys.some((one) => (one.endsWith(".") ? key.startsWith(one) : key === one));
  const settings = areas.flatMap((area) => area.settings).filter(({ key }) => isAsked(key));
  return <TopicTables topic={topicOf({ title: step.title, manual: "", settings })} />;
}

const sides = ["X", "Y", "Z"];

/** The size of the table, which is the size of its picture and its limits. */
function TableSize({ areas }: { areas: readonly SettingArea[] }) {
  const set = useSet();
  const unit = useLengthUnit();
  const entries = areas.flatMap((area) => area.settings);
  const listOf = (key: string) => partsOf(entries.find((entry) => entry.key === key)?.value ?? "");
  const [typed, setTyped] = useState<Record<string, string>>({});
  const size = listOf("view.table_mm").map((text) => mm(Number(text)));
  const shown = (n: number) => shortText(size[n] ?? mm(0), unit);
  const write = async () => {
    const sizes = sides.map((side, n) => lengthOf(typed[side] ?? shown(n), unit) ?? mm(0));
    if (sizes.some((one) => one <= 0)) return;
    const [x = 0, y = 0, z = 0] = sizes.map((one) => Number(one.toFixed(4)));
    const beside = (key: string, first: number[]) =>
      `[${[...first, ...listOf(key).slice(3)].join(", ")}]`;
    const wanted: [string, string][] = [
      ["view.table_mm", `[${x}, ${y}, ${z}]`],
      ["limits.low", beside("limits.low", [0, 0, -z])],
      ["limits.high", beside("limits.high", [x, y, z])],
    ];
    for (const [key, value] of wanted) if (!(await set(key, value))) return;
    setTyped({});
  };
  return (
    <form
      className="setup-size"
      onSubmit={(event) => {
        event.preventDefault();
        void write();
      }}
    >
      {sides.map((side, n) => (
        <Field
          key={side}
          label={t("Size in {0}", side)}
          unit={unit.linear}
          value={typed[side] ?? shown(n)}
          onChange={(text) => setTyped({ ...typed, [side]: text })}
        />
      ))}
      <Button type="submit">Set the size</Button>
    </form>
  );
}
