import { openSetup } from "../actions/go";
import { useHands, useScreen, useShown, useSnapshot } from "../app/context";
import { inMenu, useCommands } from "../command/table";
import { FaceSwitch } from "../operator/FaceSwitch";
import { themeNames, themes } from "../theme/theme";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Panel } from "../ui/Panel";
import type { SettingArea } from "../wire/messages";
import { language, languages, speak, t } from "../words/words";
import { Devices } from "./Devices";
import { MachineForm } from "./MachineForm";
import { Password } from "./Password";
import { SettingsKept } from "./SettingsKept";
import { isFresh } from "./setUp";
import "./settings.css";
import { SheetsAppearChoice } from "./SheetsAppearChoice";
import { useSettings } from "./useSettings";

/** Settings of this browser, of who may connect, and of the machine. */
export function SettingsScreen() {
  const areas = useSettings();
  const owner = useShown((shown) => shown.who?.role === "owner");
  return (
    <div className="settings page">
      <h1>{t("Settings")}</h1>
      <div className="settings-columns">
        <div className="settings-column">
          <ThisBrowser />
          <SettingsKept />
          {owner && <Devices />}
          <Password />
          <About />
        </div>
        <div className="settings-machines">
          <FirstStart areas={areas} />
          <MachineForm areas={areas} />
          <MachineSettings />
        </div>
      </div>
    </div>
  );
}

/** Leads through the settings of a new machine; in short where something was set already. */
function FirstStart({ areas }: { areas: readonly SettingArea[] }) {
  if (areas.length === 0) return null;
  const fresh = isFresh(areas);
  return (
    <section
      className={`first-start ${fresh ? "first-start-new" : ""}`}
      aria-label={t("First start")}
    >
      <p>
        {fresh
          ? t(
              "This machine was not set up yet: units, table size, axes, limits, spindle, and what is wired.",
            )
          : t("Units, table size, axes, limits, spindle and what is wired, one after the other.")}
      </p>
      <ActionButton action={openSetup} look={fresh ? "primary" : "plain"}>
        Set up…
      </ActionButton>
    </section>
  );
}

function ThisBrowser() {
  const { screen } = useHands();
  const theme = useScreen("theme");
  return (
    <Panel title="This browser">
      <dl className="settings-list">
        <div>
          <dt>{t("Theme")}</dt>
          <dd>
            <Choice
              label="Theme"
              options={themes.map((value) => ({ value, words: themeNames[value] }))}
              value={theme}
              onChange={screen.wear}
            />
          </dd>
        </div>
        <div>
          <dt>{t("Language")}</dt>
          <dd>
            <Choice label="Language" options={languages} value={language} onChange={speak} />
          </dd>
        </div>
        <div>
          <dt>{t("Layout")}</dt>
          <dd>
            <FaceSwitch />
          </dd>
        </div>
        <div>
          <dt>{t("Fill-in sheets appear")}</dt>
          <dd>
            <SheetsAppearChoice />
          </dd>
        </div>
        <div>
          <dt>{t("Keys")}</dt>
          <dd>
            <Button onPress={() => screen.open({ kind: "keys" })}>Change…</Button>
          </dd>
        </div>
      </dl>
    </Panel>
  );
}

/** Each command that shows and changes settings has its sheet. */
function MachineSettings() {
  const { screen } = useHands();
  const table = useCommands();
  const entries = [...inMenu(table, "values"), ...inMenu(table, "settings")];
  return (
    <Panel title="Commands that change settings" className="settings-machine">
      <ul className="settings-sheets">
        {entries
          .filter(({ parameters }) => parameters.length > 0)
          .map(({ letters, name, doc }) => (
            <li key={letters}>
              <Button onPress={() => screen.open({ kind: "command", letters, given: [] })}>
                {letters}
              </Button>
              <div>
                <b>{name}</b>
                <p>{doc}</p>
              </div>
            </li>
          ))}
      </ul>
    </Panel>
  );
}

function About() {
  const kerf = useSnapshot("kerf");
  const machine = useSnapshot("machine");
  return (
    <Panel title="About">
      <p className="settings-about">
        {t(
          "Kerf {0}, machine: {1}. This page is not a safety device: a machine needs an emergency stop that is wired.",
          kerf ?? "",
          machine?.name ?? "",
        )}
      </p>
    </Panel>
  );
}
