import { useCallback, useEffect, useState } from "react";
import { useHands } from "../app/context";
import { deleteAt, getJson, postJson } from "../link/http";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import type { Role } from "../wire/messages";

interface Device {
  readonly number: number;
  readonly name: string;
  readonly role: Role;
}

const roles: readonly { readonly role: Role; readonly may: string }[] = [
  { role: "observer", may: "looks, stops, holds" },
  { role: "operator", may: "runs and drives" },
  { role: "setter", may: "changes settings" },
  { role: "owner", may: "lets devices in" },
];

/** Devices that may connect over the network, and the code that lets a new one in. */
export function Devices() {
  const { screen } = useHands();
  const [devices, setDevices] = useState<readonly Device[]>([]);
  const [code, setCode] = useState<string | null>(null);
  const refused = useCallback((error: Error) => screen.tell(error.message), [screen]);
  const read = useCallback(
    () => getJson<Device[]>("/api/devices").then(setDevices, refused),
    [refused],
  );
  useEffect(() => void read(), [read]);
  const invite = (role: Role) =>
    postJson<{ code: string }>("/api/pair/code", { role }).then(
      (made) => setCode(made.code),
      refused,
    );
  const revoke = (number: number) => deleteAt(`/api/devices/${number}`).then(read, refused);
  return (
    <Panel title="Devices">
      {devices.length === 0 && <p className="settings-words">No other device is paired.</p>}
      {devices.map(({ number, name, role }) => (
        <div key={number} className="devices-row">
          <span>
            <b>{name}</b> · {role}
          </span>
          <Button size="small" onPress={() => void revoke(number)}>
            Revoke
          </Button>
        </div>
      ))}
      {code && (
        <output className="devices-code" aria-label="Code for the new device">
          {code}
        </output>
      )}
      <fieldset className="devices-new" aria-label="Let a device in">
        {roles.map(({ role, may }) => (
          <Button key={role} size="small" onPress={() => void invite(role)}>
            New {role}: {may}
          </Button>
        ))}
      </fieldset>
    </Panel>
  );
}
