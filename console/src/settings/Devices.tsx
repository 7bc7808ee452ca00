import { useCallback, useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { deleteAt, getJson, postJson } from "../link/http";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import type { Role } from "../wire/messages";
import { t } from "../words/words";

interface Device {
  readonly number: number;
  readonly name: string;
  readonly role: Role;
}

const roles: readonly { readonly role: Role; readonly may: string }[] = [
  { role: "observer", may: t("looks, stops, holds") },
  { role: "operator", may: t("runs and drives") },
  { role: "setter", may: t("changes settings") },
  { role: "owner", may: t("lets devices in") },
];

/** The names of the roles; the server tells the English ones. */
const names: Readonly<Record<Role, string>> = {
  observer: t("observer"),
  operator: t("operator"),
  setter: t("setter"),
  owner: t("owner"),
};

/** Devices that may connect over the network, and the code that lets a new one in. */
export function Devices() {
  const { screen } = useHands();
  const [devices, setDevices] = useState<readonly Device[]>([]);
  const [shown, setShown] = useState<{ code: string; role: Role; after: number } | null>(null);
  const clients = useSnapshot("clients");
  const wrongCode = useSnapshot("messages")?.findLast(({ text }) => text.startsWith("Pairing: "));
  const refused = useCallback((error: Error) => screen.tell(error.message), [screen]);
  const read = useCallback(
    () => getJson<Device[]>("/api/devices").then(setDevices, refused),
    [refused],
  );
  // A device that was just let in comes as a page.
  // biome-ignore lint/correctness/useExhaustiveDependencies: whoever comes or goes
  useEffect(() => void read(), [read, clients]);
  // A code is good for one device.
  const code = shown && devices.length <= shown.after ? shown : null;
  const invite = (role: Role) =>
    postJson<{ code: string }>("/api/pair/code", { role }).then(
      (made) => setShown({ code: made.code, role, after: devices.length }),
      refused,
    );
  const revoke = (number: number) => deleteAt(`/api/devices/${number}`).then(read, refused);
  return (
    <Panel title="Devices">
      {devices.length === 0 && <p className="settings-words">{t("No other device is paired.")}</p>}
      {devices.map(({ number, name, role }) => (
        <div key={number} className="devices-row">
          <span>
            <b>{name}</b> · {names[role]}
          </span>
          <Button size="small" onPress={() => void revoke(number)}>
            Revoke
          </Button>
        </div>
      ))}
      {code && (
        <>
          <output className="devices-code" aria-label={t("Code for the new device")}>
            {code.code}
          </output>
          <p className="settings-words">
            {t(
              "Enter it on the new device within five minutes. It comes in as {0}.",
              names[code.role],
            )}
          </p>
          {wrongCode && (
            <p className="settings-words" role="status">
              {wrongCode.text}
            </p>
          )}
        </>
      )}
      <fieldset className="devices-new" aria-label={t("Let a device in")}>
        {roles.map(({ role, may }) => (
          <Button key={role} size="small" onPress={() => void invite(role)}>
            {t("New {0}: {1}", names[role], may)}
          </Button>
        ))}
      </fieldset>
    </Panel>
  );
}
