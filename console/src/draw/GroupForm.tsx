import { useState } from "react";
import { shortText } from "../app/units";
import { type Degrees, type LengthUnit, type Mm, perMinuteInUnit } from "../units/quantity";
import type { GroupState } from "../wire/messages";
import { t } from "../words/words";
import { isWrong, type Read, readAngle, readLength, readNumber, readSpeed } from "./entry";
import { num } from "./tools/tool";
import type { Desk } from "./useDesk";

interface GroupFormProps {
  group: GroupState;
  unit: LengthUnit;
  desk: Desk;
}

interface Row {
  readonly key: string;
  readonly label: string;
  readonly title: string;
  readonly text: (group: GroupState, unit: LengthUnit) => string;
  readonly read: (text: string, unit: LengthUnit) => Read<number>;
}

type Words = readonly [label: string, title: string];

const length = (key: string, [label, title]: Words, value: (group: GroupState) => Mm): Row => ({
  key,
  label,
  title,
  text: (group, unit) => shortText(value(group), unit),
  read: readLength,
});

const output = (key: "tool" | "cut", [label, title]: Words): Row => ({
  key,
  label,
  title,
  text: (group) => String(group[key]),
  read: readNumber,
});

const rows: readonly Row[] = [
  length("offset", [t("Offset"), t("Of the tool path, right of travel")], (g) => g.offset),
  length("rough", [t("Rough"), t("What a first pass leaves")], (g) => g.rough),
  length(
    "tag",
    [t("Tab"), t("Left out at the path's beginning, so that the part stays in the sheet")],
    (g) => g.tag,
  ),
  output("tool", [t("Tool"), t("Tool output, 1 to 3")]),
  output("cut", [t("Output"), t("Cut output, 1 to 3")]),
];

/** Form for the cutting of a group: its settings hold for all its shapes. */
export function GroupForm({ group, unit, desk }: GroupFormProps) {
  const set = (words: string) => desk.send(`set ${group.name} ${words}`);
  return (
    <div className="group-form">
      <DepthRow group={group} unit={unit} set={set} />
      {rows.map((row) => (
        <Entry
          key={row.key}
          label={row.label}
          title={row.title}
          text={row.text(group, unit)}
          onText={(text) => {
            const read = row.read(text, unit);
            if (!isWrong(read)) set(`${row.key}=${num(read.value)}`);
          }}
        />
      ))}
      <LeadRow name="lead-in" label={t("Lead-in")} lead={group.leadIn} unit={unit} set={set} />
      <LeadRow name="lead-out" label={t("Lead-out")} lead={group.leadOut} unit={unit} set={set} />
      <Entry
        label={t("Speed, {0}/min", unit.linear)}
        title={t("Cutting speed; max is the machine's cutting speed")}
        text={group.speedMmMin === null ? "max" : tidy(perMinuteInUnit(group.speedMmMin, unit))}
        onText={(text) => {
          const read = readSpeed(text, unit);
          set(`speed=${isWrong(read) ? "max" : num(read.value)}`);
        }}
      />
      <label className="group-check">
        <input
          type="checkbox"
          checked={group.double}
          onChange={() => set(`double=${group.double ? "off" : "on"}`)}
        />
        {t("Double cut, on both sides of the line")}
      </label>
      <label className="group-check">
        <input
          type="checkbox"
          checked={group.traversal}
          onChange={() => set(`traversal=${group.traversal ? "off" : "on"}`)}
        />
        {t("Travel only")}
      </label>
    </div>
  );
}

interface RowProps {
  unit: LengthUnit;
  set: (words: string) => void;
}

/** Through, by the heights of the shape, or so deep; in passes. */
function DepthRow({ group, unit, set }: RowProps & { group: GroupState }) {
  return (
    <>
      <Entry
        label={t("Depth")}
        title={t(
          "through, 3d, or the height of the cut over the surface, negative into the material",
        )}
        text={
          typeof group.height === "number"
            ? shortText(group.height, unit)
            : depthWords(group.height)
        }
        onText={(text) => {
          const read = readLength(text, unit);
          const [word] = /^(thru|through|3d)$/i.exec(text.trim()) ?? [];
          if (word) set(`height=${/^3d$/i.test(word) ? "3d" : "thru"}`);
          else if (!isWrong(read)) set(`height=${num(read.value)}`);
        }}
      />
      <Entry
        label={t("Per pass")}
        title={t("Depth of one pass; off cuts at once")}
        text={group.pass === null ? "off" : shortText(group.pass, unit)}
        onText={(text) => {
          const read = readLength(text, unit);
          set(`pass=${isWrong(read) ? "off" : num(read.value)}`);
        }}
      />
    </>
  );
}

const depthWords = (height: string): string => (height === "thru" ? t("through") : height);

interface LeadRowProps extends RowProps {
  name: string;
  label: string;
  lead: readonly [Mm, Degrees];
}

/** Radius and angle of an arc onto the path, or off it. */
function LeadRow({ name, label, lead, unit, set }: LeadRowProps) {
  return (
    <Entry
      label={label}
      title={t("Radius, angle in degrees")}
      wide
      text={`${shortText(lead[0], unit)}, ${tidy(lead[1])}`}
      onText={(text) => {
        const [radius = "", angle = "90"] = text.split(",");
        const [r, a] = [readLength(radius, unit), readAngle(angle)];
        if (!isWrong(r) && !isWrong(a)) set(`${name}=${num(r.value)},${num(a.value)}`);
      }}
    />
  );
}

interface EntryProps {
  label: string;
  title: string;
  text: string;
  wide?: boolean;
  onText: (text: string) => void;
}

/** An entry that is taken with Enter or when it is left. */
function Entry({ label, title, text, wide, onText }: EntryProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const take = () => {
    if (typed !== null && typed.trim() !== text) onText(typed);
    setTyped(null);
  };
  return (
    <label className={wide ? "group-entry group-wide" : "group-entry"} title={title}>
      <span>{label}</span>
      <input
        value={typed ?? text}
        autoComplete="off"
        spellCheck={false}
        onChange={({ target }) => setTyped(target.value)}
        onBlur={take}
        onKeyDown={(event) => event.key === "Enter" && take()}
      />
    </label>
  );
}

const tidy = (value: number): string => String(Number(value.toFixed(4)));
