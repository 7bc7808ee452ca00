import { useEffect, useState } from "react";
import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { getJson } from "../link/http";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Panel } from "../ui/Panel";
import { Pick } from "../ui/Pick";
import type { SettingArea, SettingEntry } from "../wire/messages";
import { shownUnit, shownValue, writtenValue } from "./value";

/** Every setting of the machine by its area, to be looked for and changed; in the unit that is set. */
export function MachineForm() {
  const areas = useSettings();
  const [title, setTitle] = useState("");
  const [wanted, setWanted] = useState("");
  const first = areas[0]?.title ?? "";
  const chosen =
    wanted.trim() === "" ? areas.filter((area) => area.title === (title || first)) : once(areas);
  const fits = ({ key, doc }: SettingEntry) =>
    `${key} ${doc}`.toLowerCase().includes(wanted.trim().toLowerCase());
  return (
    <Panel title="Settings of the machine" className="machine-form">
      <div className="machine-form-head">
        <Pick
          label="Area"
          labelled
          options={areas.map((area) => ({ value: area.title, words: area.title }))}
          value={title || first}
          onChange={setTitle}
        />
        <Field label="Look for" value={wanted} onChange={setWanted} placeholder="speed" />
      </div>
      {chosen.map((area) => (
        <section key={area.title} aria-label={area.title}>
          {wanted.trim() === "" && <p className="settings-words">{area.manual}</p>}
          {area.settings.filter(fits).map((entry) => (
            <SettingField key={`${entry.key} ${entry.value}`} entry={entry} />
          ))}
        </section>
      ))}
    </Panel>
  );
}

/** Every setting in one area only: some stand in two. */
function once(areas: readonly SettingArea[]): SettingArea[] {
  const seen = new Set<string>();
  const isNew = ({ key }: SettingEntry) => !seen.has(key) && seen.add(key);
  return areas.map((area) => ({ ...area, settings: area.settings.filter(isNew) }));
}

/** One setting: it is sent when the field is left or Enter pressed. */
function SettingField({ entry }: { entry: SettingEntry }) {
  const hands = useHands();
  const mm = useSnapshot("units")?.mm ?? 1;
  const shown = shownValue(entry, mm);
  const [text, setText] = useState(shown);
  const [wrong, setWrong] = useState<string>();
  const { kind } = entry;
  const send = async (value: string | undefined) => {
    if (value === undefined) return setWrong("This is not a value of it.");
    setWrong(undefined);
    const done = await drive(worldOf(hands), { do: "set", key: entry.key, value });
    if (!done) setText(shown);
  };
  const leave = () => text !== shown && void send(writtenValue(entry, text, mm));
  const facts = [
    entry.bound && `allowed: ${entry.bound}`,
    `usual: ${shownValue({ ...entry, value: entry.default }, mm)}`,
  ];
  const hint = `${entry.doc} (${facts.filter(Boolean).join(", ")})`;
  if (kind.is === "flag" || kind.is === "choice") {
    const words = kind.is === "flag" ? ["true", "false"] : kind.words;
    const all = words.includes(entry.value) ? words : [entry.value, ...words];
    const options = all.map((word) => ({ value: word, words: named[word] ?? word }));
    const Way = all.length <= 3 ? Choice : Pick;
    return (
      <div className="setting">
        <span className="field-label">
          {nameOf(entry.key)} <code>{entry.key}</code>
        </span>
        <Way
          label={nameOf(entry.key)}
          options={options}
          value={entry.value}
          onChange={(value) => void send(value)}
        />
        <span className="field-hint">{hint}</span>
      </div>
    );
  }
  return (
    <form
      className="setting"
      onSubmit={(event) => {
        event.preventDefault();
        leave();
      }}
    >
      <Field
        label={nameOf(entry.key)}
        value={text}
        onChange={setText}
        onBlur={leave}
        unit={shownUnit(entry, mm).unit}
        hint={hint}
        error={wrong}
      />
    </form>
  );
}

/** Endings of keys that name the unit, which stands behind the value. */
const unitEnding = /_(mm_s[23]?|mm|s|ms|ns|us|hz|khz|deg|percent|px|twips)$/;

/** `speeds.cut.xy` as a person reads it: Speeds, cut, xy. */
function nameOf(key: string): string {
  const name = key
    .split(".")
    .map((part) => part.replace(unitEnding, "").replaceAll("_", " "))
    .join(", ");
  return name.charAt(0).toUpperCase() + name.slice(1);
}

const named: Record<string, string> = { true: "yes", false: "no" };

/** The settings, read anew when one of them changed. */
function useSettings(): readonly SettingArea[] {
  const changes = useSnapshot("settings");
  const { screen } = useHands();
  const [areas, setAreas] = useState<readonly SettingArea[]>([]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: read anew when settings changed
  useEffect(() => {
    getJson<SettingArea[]>("/api/settings").then(setAreas, (error: Error) =>
      screen.tell(error.message),
    );
  }, [changes, screen]);
  return areas;
}
