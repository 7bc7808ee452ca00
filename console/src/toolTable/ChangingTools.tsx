import { drive } from "../actions/ask";
import { whenIdle } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { placeText } from "../app/units";
import { useLengthUnit } from "../app/useLengthUnit";
import { useSettings } from "../settings/useSettings";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Pick } from "../ui/Pick";
import { type LengthUnit, mm } from "../units/quantity";
import { t } from "../words/words";

/** The inputs to which a sensor may be wired. */
const inputs = Array.from({ length: 12 }, (_, n) => String(n + 1));

/** Words in place of a setting that is not given. */
const none = "none";

const m6 = [
  { value: "true", words: "Goes there and measures" },
  { value: "false", words: "Asks where it stands" },
] as const;

const keeps = [
  { value: "false", words: "Measured at each change" },
  { value: "true", words: "Kept in their holders" },
] as const;

/** The places where tools are changed and measured, with buttons that set each to where the tool is. */
export function ChangingTools() {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => whenIdle({ shown, link, screen }));
  const base = useSnapshot("motion")?.at.base;
  const unit = useLengthUnit();
  const settings = useSettings().flatMap(({ settings }) => settings);
  const read = (key: string) => settings.find((it) => it.key === key)?.value ?? none;
  const set = (key: string, value: string) => drive(worldOf(hands), { do: "set", key, value });
  const setHere = async (what: "place" | "sensor") => {
    const [x, y] = [base?.[0] ?? 0, base?.[1] ?? 0].map((at) => Number(at.toFixed(3)));
    if (await set(`tool_change.${what}_x`, String(x)))
      await set(`tool_change.${what}_y`, String(y));
  };
  const isPlaced = (what: "place" | "sensor") => placeOf(what, read) !== undefined;
  return (
    <section className="tool-table-form" aria-label={t("Changing tools")}>
      <h3>{t("Changing tools")}</h3>
      <p>{t("M6 of G-code")}</p>
      <Choice
        label="M6 of G-code"
        options={m6}
        value={read("m6_runs_c9") === "true" ? "true" : "false"}
        onChange={(value) => void set("m6_runs_c9", value)}
      />
      <Place words={t("Tools are changed at")} what="place" {...{ read, unit }} />
      <Button refused={refused} onPress={() => void setHere("place")}>
        Change tools where the tool is now
      </Button>
      <Place words={t("The sensor is at")} what="sensor" {...{ read, unit }} />
      <Button refused={refused} onPress={() => void setHere("sensor")}>
        The tool is over the sensor now
      </Button>
      <Pick
        label="Input of the sensor"
        labelled
        options={[
          { value: none, words: t("No sensor") },
          ...inputs.map((input) => ({ value: input, words: input })),
        ]}
        value={read("tool_change.sensor_input")}
        onChange={(value) =>
          isPlaced("sensor") || value === none
            ? void set("tool_change.sensor_input", value)
            : screen.tell(t("Move the tool over the sensor first, and press the button above."))
        }
      />
      <Pick
        label="Input of a loose plate"
        labelled
        options={[
          { value: none, words: t("No plate") },
          ...inputs.map((input) => ({ value: input, words: input })),
        ]}
        value={read("tool_change.plate_input")}
        onChange={(value) => void set("tool_change.plate_input", value)}
      />
      <p>{t("Lengths of tools")}</p>
      <Choice
        label="Lengths of tools"
        options={keeps}
        value={read("tool_change.keeps_lengths") === "true" ? "true" : "false"}
        onChange={(value) => void set("tool_change.keeps_lengths", value)}
      />
    </section>
  );
}

type Read = (key: string) => string;

/** A place that two settings name, mm of the table base. */
function placeOf(what: string, read: Read) {
  const [x, y] = ["x", "y"].map((axis) => read(`tool_change.${what}_${axis}`));
  return x === none || y === none ? undefined : ([mm(Number(x)), mm(Number(y))] as const);
}

interface PlaceProps {
  words: string;
  what: string;
  read: Read;
  unit: LengthUnit;
}

function Place({ words, what, read, unit }: PlaceProps) {
  const place = placeOf(what, read);
  return (
    <p>
      {words}{" "}
      {place ? t("{0} of the table", placeText(place, unit)) : t("no place of their own yet.")}
    </p>
  );
}
