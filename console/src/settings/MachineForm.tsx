import { useState } from "react";
import { useHands } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Panel } from "../ui/Panel";
import { Pick } from "../ui/Pick";
import type { SettingArea, SettingEntry } from "../wire/messages";
import { t } from "../words/words";
import { isMeant, topicName } from "./names";
import { TopicTables } from "./TopicTables";
import { topicOf } from "./tables";

/** Every setting of the machine in tables by topic, found by the words of whoever looks for it. */
export function MachineForm({ areas }: { areas: readonly SettingArea[] }) {
  const [title, setTitle] = useState("");
  const [text, setText] = useState("");
  const wanted = text.trim();
  const first = areas[0]?.title ?? "";
  const found = wanted === "" ? [] : once(areas).map((area) => only(area, wanted));
  const chosen =
    wanted === ""
      ? areas.filter((area) => area.title === (title || first))
      : found.filter(({ settings }) => settings.length > 0);
  return (
    <Panel title="Settings of the machine" className="machine-form">
      <div className="machine-form-head">
        <Field
          label="Search settings"
          value={text}
          onChange={setText}
          placeholder="backup, inch, probe"
        />
        <Pick
          label="Topic"
          labelled
          options={areas.map((area) => ({ value: area.title, words: topicName(area.title) }))}
          value={title || first}
          onChange={(next) => {
            setTitle(next);
            setText("");
          }}
        />
      </div>
      {wanted !== "" && <OtherPlaces wanted={wanted} />}
      {chosen.map((area) => (
        <TopicTables key={area.title} topic={topicOf(area)} />
      ))}
    </Panel>
  );
}

/** Things that people look for here and that are not settings. */
const elsewhere: readonly (readonly [string, string, string])[] = [
  [
    "probe touch plate zero tool length taster antasten nullen werkzeuglänge",
    t("Zero Z with a touch plate (C2)"),
    "C2",
  ],
  [
    "backup save load restore export import file profile sicherung sichern laden wiederherstellen",
    t("Save and load all settings: Backup, on this page"),
    "",
  ],
  [
    "inch metric millimetre unit imperial zoll einheit",
    t("Inches or millimetres: Units, below"),
    "",
  ],
];

function OtherPlaces({ wanted }: { wanted: string }) {
  const { screen } = useHands();
  const meant = elsewhere.filter(([words]) => words.includes(wanted.toLowerCase()));
  return meant.map(([, title, letters]) => (
    <p key={title} className="settings-words">
      {letters === "" ? (
        title
      ) : (
        <Button size="small" onPress={() => screen.open({ kind: "command", letters, given: [] })}>
          {title}
        </Button>
      )}
    </p>
  ));
}

const only = (area: SettingArea, wanted: string): SettingArea => ({
  ...area,
  settings: area.settings.filter((entry) => isMeant(entry, area.title, wanted)),
});

/** Every setting in one area only: some stand in two. */
function once(areas: readonly SettingArea[]): SettingArea[] {
  const seen = new Set<string>();
  const isNew = ({ key }: SettingEntry) => !seen.has(key) && seen.add(key);
  return areas.map((area) => ({ ...area, settings: area.settings.filter(isNew) }));
}
