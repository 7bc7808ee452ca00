import { useState } from "react";
import { FileTrigger } from "react-aria-components";
import { useHands, useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";
import { downloadText } from "../link/download";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import { Sheet } from "../ui/Sheet";
import type { SettingArea, SettingChange } from "../wire/messages";
import { t } from "../words/words";
import { fullName } from "./names";
import { useSet } from "./SettingValue";
import { fileOf, type Loaded, readFile, type Wanted } from "./settingsFile";

/** Saves all settings as a file and loads them again; tells what was changed, and takes it back. */
export function SettingsKept({ areas }: { areas: readonly SettingArea[] }) {
  const machine = useSnapshot("machine")?.name ?? "";
  const { screen } = useHands();
  const [loaded, setLoaded] = useState<Loaded | null>(null);
  const read = async (file: File | undefined) => {
    if (!file) return;
    const found = readFile(await file.text(), areas);
    if (found.wanted.length > 0 || found.unknown.length > 0) setLoaded(found);
    else screen.tell(t("{0}: every setting is as in this file already.", file.name));
  };
  const save = () => downloadText("machine-settings.txt", fileOf(areas, machine));
  return (
    <Panel title="Backup">
      <p className="settings-words">
        {t(
          "All settings of the machine as a text file, to be kept, compared, or brought to another machine.",
        )}
      </p>
      <div className="settings-kept">
        <Button onPress={save}>Save settings</Button>
        <FileTrigger
          acceptedFileTypes={[".txt"]}
          onSelect={(files) => void read(files?.[0] ?? undefined)}
        >
          <Button>Load settings…</Button>
        </FileTrigger>
      </div>
      <Changes />
      {loaded && <LoadSheet loaded={loaded} onClose={() => setLoaded(null)} />}
    </Panel>
  );
}

/** Asks before settings are loaded: each with its value before and after. */
function LoadSheet({ loaded, onClose }: { loaded: Loaded; onClose: () => void }) {
  const load = useLoad();
  const { wanted, unknown } = loaded;
  const foot = (
    <>
      <Button onPress={onClose}>Cancel</Button>
      <Button
        look="primary"
        refused={wanted.length === 0 ? t("Nothing in this file is another value.") : undefined}
        onPress={() => {
          onClose();
          void load(wanted);
        }}
      >
        {wanted.length === 1 ? t("Change 1 setting") : t("Change {0} settings", wanted.length)}
      </Button>
    </>
  );
  return (
    <Sheet title="Load settings?" onClose={onClose} foot={foot}>
      <ul className="settings-changes">
        {wanted.map(({ key, from, to }) => (
          <li key={key}>
            <b>{fullName(key)}</b> <ChangeText from={from} to={to} />
          </li>
        ))}
        {unknown.map((line) => (
          <li key={line} className="settings-unknown">
            {t("This machine has no such setting, it is left out: {0}", line)}
          </li>
        ))}
      </ul>
    </Sheet>
  );
}

const ChangeText = ({ from, to }: { from: string; to: string }) => (
  <span>
    {from || "nothing"} → {to || "nothing"}
  </span>
);

/** Changes settings one by one; what contradicts another first is tried again when that is changed. */
function useLoad() {
  const set = useSet();
  const { screen } = useHands();
  return async (wanted: readonly Wanted[]) => {
    let left = wanted;
    while (left.length > 0) {
      const refused: Wanted[] = [];
      for (const one of left) if (!(await set(one.key, one.to))) refused.push(one);
      if (refused.length === left.length) break;
      left = refused;
    }
    const done = wanted.length - left.length;
    const names = left.map(({ key }) => fullName(key)).join("; ");
    screen.tell(
      left.length === 0 ? t("{0} settings are loaded.", done) : t("Not loaded: {0}.", names),
    );
  };
}

/** Number of changes that are in sight at first. */
const fewChanges = 5;

const noChanges: readonly SettingChange[] = [];

function Changes() {
  const count = useSnapshot("settings");
  const set = useSet();
  const changes = useFetched("/api/settings?changes", noChanges, count);
  const [all, setAll] = useState(false);
  const shown = all ? changes : changes.slice(0, fewChanges);
  return (
    <section aria-label={t("Changes of settings")}>
      <h3 className="settings-head">{t("Changes")}</h3>
      {changes.length === 0 && <p className="settings-words">{t("Nothing was changed so far.")}</p>}
      <ol className="settings-changes">
        {shown.map(({ at, key, from, to, by, through }, n) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: the same setting may change twice in a second
          <li key={n}>
            <time dateTime={new Date(at * 1000).toISOString()}>
              {new Date(at * 1000).toLocaleString()}
            </time>{" "}
            <b>{fullName(key)}</b> <ChangeText from={from} to={to} />
            <span className="settings-words">
              {t("by {0}", by || t("this machine"))}
              {through && t(", with {0}", through)}
            </span>
            <Button
              size="small"
              look="quiet"
              aria-label={t("Take back: {0}, {1}", fullName(key), from)}
              onPress={() => void set(key, from)}
            >
              Take back
            </Button>
          </li>
        ))}
      </ol>
      {!all && changes.length > fewChanges && (
        <Button size="small" onPress={() => setAll(true)}>
          {t("All {0} changes", changes.length)}
        </Button>
      )}
    </section>
  );
}
