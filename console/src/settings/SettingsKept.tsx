import { useState } from "react";
import { FileTrigger } from "react-aria-components";
import { useHands, useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";
import { downloadText } from "../link/download";
import { getJson } from "../link/http";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import type { SettingArea, SettingChange } from "../wire/messages";
import { t } from "../words/words";
import { ChangeText, LoadSheet } from "./LoadSheet";
import { fullName } from "./names";
import { useSet } from "./SettingValue";
import { fileOf, type Loaded, readFile } from "./settingsFile";

/** Fetches the settings as they are now: those on the page may not have come yet, or be a moment behind a change. */
const settingsNow = () => getJson<SettingArea[]>("/api/settings");

/** Saves all settings as a file and loads them again; tells what was changed, and takes it back. */
export function SettingsKept() {
  const machine = useSnapshot("machine")?.name ?? "";
  const { screen } = useHands();
  const [loaded, setLoaded] = useState<Loaded | null>(null);
  const refused = (error: Error) => screen.tell(error.message);
  const read = async (file: File | undefined) => {
    if (!file) return;
    const [text, areas] = await Promise.all([file.text(), settingsNow()]);
    const found = readFile(text, areas);
    if (found.wanted.length > 0 || found.unknown.length > 0) setLoaded(found);
    else screen.tell(t("{0}: every setting is as in this file already.", file.name));
  };
  const save = async () =>
    downloadText("machine-settings.txt", fileOf(await settingsNow(), machine));
  return (
    <Panel title="Backup">
      <p className="settings-words">
        {t(
          "All settings of the machine as a text file, to be kept, compared, or brought to another machine.",
        )}
      </p>
      <div className="settings-kept">
        <Button onPress={() => void save().catch(refused)}>Save settings</Button>
        <FileTrigger
          acceptedFileTypes={[".txt"]}
          onSelect={(files) => void read(files?.[0] ?? undefined).catch(refused)}
        >
          <Button>Load settings…</Button>
        </FileTrigger>
      </div>
      <Changes />
      {loaded && <LoadSheet loaded={loaded} onClose={() => setLoaded(null)} />}
    </Panel>
  );
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
