import { Fragment } from "react";
import { Button } from "../ui/Button";
import type { ControllerSetting } from "../wire/messages";
import { t } from "../words/words";
import { Changing } from "./Changing";
import { explained, named } from "./said";

/** The setting that is looked at, and whether it is being changed. */
export interface Chosen {
  readonly number: number;
  readonly changes: boolean;
}

interface SettingRowsProps {
  settings: readonly ControllerSetting[];
  /** Each is explained below its row. */
  explains: boolean;
  chosen: Chosen | undefined;
  choose: (chosen: Chosen | undefined) => void;
}

/** A row for each setting; below the chosen one stands what it does, and where it is changed. */
export function SettingRows({ settings, explains, chosen, choose }: SettingRowsProps) {
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
          <SettingRow
            key={setting.number}
            {...{ setting, explains, choose }}
            chosen={chosen?.number === setting.number ? chosen : undefined}
          />
        ))}
      </tbody>
    </table>
  );
}

interface SettingRowProps extends Pick<SettingRowsProps, "explains" | "chosen" | "choose"> {
  setting: ControllerSetting;
}

function SettingRow({ setting, explains, chosen, choose }: SettingRowProps) {
  const { number, value, unit } = setting;
  return (
    <Fragment>
      <tr>
        <th scope="row">
          <Button
            look="quiet"
            size="small"
            className="controller-settings-name"
            aria-expanded={chosen !== undefined}
            onPress={() => choose(chosen ? undefined : { number, changes: false })}
          >
            <b>{`$${number}`}</b> {named(setting)}
          </Button>
        </th>
        <td>{`${value} ${unit}`.trim()}</td>
        <td>
          <Button
            size="small"
            aria-label={t("Change {0}", `$${number}`)}
            onPress={() => choose({ number, changes: true })}
          >
            Change
          </Button>
        </td>
      </tr>
      {(explains || chosen) && (
        <tr className="controller-settings-below">
          <td colSpan={3}>
            <Explained setting={setting} />
            {chosen?.changes && <Changing setting={setting} onClose={() => choose(undefined)} />}
          </td>
        </tr>
      )}
    </Fragment>
  );
}

/** Explains a setting, with the controller's own words where it has some. */
function Explained({ setting }: { setting: ControllerSetting }) {
  const said = explained(setting);
  if (said.length === 0) return <p>{t("What it does is not known.")}</p>;
  return said.map((text) => <p key={text}>{text}</p>);
}
