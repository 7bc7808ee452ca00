import { useState } from "react";
import { drive } from "../actions/ask";
import { unlessReady } from "../actions/machine";
import { useHands, useShown, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import type { ControllerSetting } from "../wire/messages";
import { serverWords } from "../words/server";
import { t } from "../words/words";
import { type Differing, differing, unknownOf } from "./file";
import { whenIdleAgain } from "./whenIdleAgain";

interface ComparedProps {
  settings: readonly ControllerSetting[];
  file: ReadonlyMap<number, string>;
  onClose: () => void;
}

/** Differences between a file and the controller, and the button that writes the values of the file. */
export function Compared({ settings, file, onClose }: ComparedProps) {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const [asks, setAsks] = useState(false);
  const [writing, setWriting] = useState(false);
  const rows = differing(settings, file);
  const unknown = unknownOf(settings, file);
  const write = async () => {
    setAsks(false);
    setWriting(true);
    const world = worldOf(hands);
    for (const { setting, value } of rows) {
      const line = `$${setting.number}=${value}`;
      if (!(await drive(world, { do: "command", line })) || !(await whenIdleAgain(world))) break;
    }
    setWriting(false);
  };
  return (
    <section className="controller-settings-change" aria-label={t("Compared with the file")}>
      <h3>{t("Compared with the file")}</h3>
      {rows.length === 0 && <p role="status">{t("The controller has every value of the file.")}</p>}
      {rows.length > 0 && <Rows rows={rows} />}
      {unknown.length > 0 && (
        <p role="note">
          {t("The controller has no {0}.", unknown.map((number) => `$${number}`).join(", "))}
        </p>
      )}
      <div className="controller-settings-kept">
        {asks && (
          <>
            <p role="alert">{t("Write {0} settings into the controller?", rows.length)}</p>
            <Button look="primary" onPress={() => void write()}>
              Write
            </Button>
          </>
        )}
        {!asks && rows.length > 0 && (
          <Button
            refused={writing ? t("They are being written.") : refused}
            onPress={() => setAsks(true)}
          >
            Write the values of the file…
          </Button>
        )}
        <Button onPress={asks ? () => setAsks(false) : onClose}>{asks ? "Cancel" : "Close"}</Button>
      </div>
    </section>
  );
}

function Rows({ rows }: { rows: readonly Differing[] }) {
  return (
    <table className="controller-settings list-table">
      <thead>
        <tr>
          <th>{t("Setting")}</th>
          <th>{t("Controller")}</th>
          <th>{t("File")}</th>
        </tr>
      </thead>
      <tbody>
        {rows.map(({ setting, value }) => (
          <tr key={setting.number}>
            <th scope="row">
              <b>{`$${setting.number}`}</b> {serverWords(setting.name)}
            </th>
            <td>{setting.value}</td>
            <td>{value}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
