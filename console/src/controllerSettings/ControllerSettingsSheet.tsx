import { Fragment, useState } from "react";
import { FileTrigger } from "react-aria-components";
import { drive } from "../actions/ask";
import { unlessReady } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { downloadText } from "../link/download";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { ControllerSetting } from "../wire/messages";
import { serverWords } from "../words/server";
import { t } from "../words/words";
import { Compared } from "./Compared";
import { fileOf, found, valuesOf } from "./file";
import "./controller-settings.css";

const none: readonly ControllerSetting[] = [];

/** The settings that the controller keeps by number: found, changed, kept as a file, compared with one and made as in it. */
export function ControllerSettingsSheet({ onClose }: { onClose: () => void }) {
  const settings = useSnapshot("controllerSettings") ?? none;
  const [search, setSearch] = useState("");
  const [edited, setEdited] = useState<number>();
  const [file, setFile] = useState<ReadonlyMap<number, string>>();
  return (
    <Sheet title={t("Settings of the controller")} shape="side" onClose={onClose}>
      <p className="controller-settings-words">
        {t(
          "They are kept in the controller itself, and are read from it. What is changed here is written into it and read back.",
        )}
      </p>
      <Kept settings={settings} read={setFile} />
      {file && <Compared {...{ settings, file }} onClose={() => setFile(undefined)} />}
      <Field label="Find" placeholder="number, name or unit" value={search} onChange={setSearch} />
      <Settings settings={found(settings, search, named)} {...{ edited, edit: setEdited }} />
    </Sheet>
  );
}

/** The name of a setting in the language of the page, where it is one of those that Kerf knows. */
const named = ({ name }: ControllerSetting): string => serverWords(name);

interface KeptProps {
  settings: readonly ControllerSetting[];
  read: (values: ReadonlyMap<number, string>) => void;
}

function Kept({ settings, read }: KeptProps) {
  const machine = useSnapshot("machine")?.name ?? "";
  const { screen } = useHands();
  const take = async (file: File | undefined) => {
    if (!file) return;
    const values = valuesOf(await file.text());
    if (values.size > 0) read(values);
    else screen.tell(t("{0} has no settings of a controller ($110=5000).", file.name));
  };
  return (
    <div className="controller-settings-kept">
      <Button onPress={() => downloadText("controller-settings.txt", fileOf(machine, settings))}>
        Back up
      </Button>
      <FileTrigger
        acceptedFileTypes={[".txt", ".settings", ".nc"]}
        onSelect={(files) => void take(files?.[0] ?? undefined)}
      >
        <Button>Compare with a file…</Button>
      </FileTrigger>
    </div>
  );
}

interface ChangingProps {
  setting: ControllerSetting;
  onClose: () => void;
}

/** Another value for a setting. */
function Changing({ setting, onClose }: ChangingProps) {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const [value, setValue] = useState(setting.value);
  const write = async () => {
    const line = `$${setting.number}=${value.trim()}`;
    if (await drive(worldOf(hands), { do: "command", line })) onClose();
  };
  return (
    <section
      className="controller-settings-change"
      aria-label={t("Change {0}", `$${setting.number}`)}
    >
      <Field
        label={`$${setting.number} ${named(setting)}`}
        unit={setting.unit}
        hint={boundsOf(setting)}
        value={value}
        onChange={setValue}
        autoFocus
      />
      <div className="controller-settings-kept">
        <Button
          look="primary"
          refused={value.trim() === "" ? t("Give a value.") : refused}
          onPress={() => void write()}
        >
          Write
        </Button>
        <Button onPress={onClose}>Cancel</Button>
      </div>
    </section>
  );
}

/** The values that a setting may have, in words. */
function boundsOf({ least, most }: ControllerSetting): string | undefined {
  if (least === null && most === null) return undefined;
  if (most === null) return t("{0} or more", least ?? 0);
  if (least === null) return t("{0} or less", most);
  return t("{0} to {1}", least, most);
}

interface SettingsProps {
  settings: readonly ControllerSetting[];
  /** The number of the one that is being changed. */
  edited: number | undefined;
  edit: (number: number | undefined) => void;
}

function Settings({ settings, edited, edit }: SettingsProps) {
  if (settings.length === 0) return <p role="status">{t("Nothing is found.")}</p>;
  return (
    <table className="controller-settings list-table">
      <thead>
        <tr>
          <th>{t("Setting")}</th>
          <th>{t("Value")}</th>
          <td />
        </tr>
      </thead>
      <tbody>
        {settings.map((setting) => (
          <Fragment key={setting.number}>
            <tr>
              <th scope="row">
                <b>{`$${setting.number}`}</b> {named(setting)}
              </th>
              <td>{`${setting.value} ${setting.unit}`.trim()}</td>
              <td>
                <Button
                  size="small"
                  aria-label={t("Change {0}", `$${setting.number}`)}
                  onPress={() => edit(setting.number)}
                >
                  Change
                </Button>
              </td>
            </tr>
            {edited === setting.number && (
              <tr>
                <td colSpan={3}>
                  <Changing setting={setting} onClose={() => edit(undefined)} />
                </td>
              </tr>
            )}
          </Fragment>
        ))}
      </tbody>
    </table>
  );
}
