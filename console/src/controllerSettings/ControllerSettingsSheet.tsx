import { useState } from "react";
import { FileTrigger } from "react-aria-components";
import { useHands, useSnapshot } from "../app/context";
import { downloadText } from "../link/download";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { ControllerSetting } from "../wire/messages";
import { t } from "../words/words";
import { Compared } from "./Compared";
import { fileOf, found, valuesOf } from "./file";
import { type Chosen, SettingRows } from "./SettingRows";
import { explained, named } from "./said";
import "./controller-settings.css";

const none: readonly ControllerSetting[] = [];

/** The settings that the controller keeps by number: found, changed, kept as a file, compared with one and made as in it. */
export function ControllerSettingsSheet({ onClose }: { onClose: () => void }) {
  const settings = useSnapshot("controllerSettings") ?? none;
  const [search, setSearch] = useState("");
  const [chosen, choose] = useState<Chosen>();
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
      <Field
        label="Find"
        placeholder="number, name, unit or what it does"
        value={search}
        onChange={setSearch}
      />
      <SettingRows
        settings={found(settings, search, (it) => [named(it), ...explained(it)].join(" "))}
        explains={search.trim() !== ""}
        {...{ chosen, choose }}
      />
    </Sheet>
  );
}

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
      <Button
        refused={settings.length === 0 ? t("The controller has not told its settings.") : undefined}
        onPress={() => downloadText("controller-settings.txt", fileOf(machine, settings))}
      >
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
