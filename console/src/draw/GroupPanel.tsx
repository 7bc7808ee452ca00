import { useState } from "react";
import { useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";
import { GroupForm } from "./GroupForm";
import type { Scene } from "./scene";
import type { Desk } from "./useDesk";

interface GroupPanelProps {
  desk: Desk;
  scene: Scene;
}

/** The eight groups: how many shapes, whether they are cut, how. */
export function GroupPanel({ desk, scene }: GroupPanelProps) {
  const groups = useSnapshot("drawing")?.groups ?? [];
  const units = useSnapshot("units");
  const [open, setOpen] = useState("black");
  const some = scene.selected.size > 0;
  const shown = groups.find(({ name }) => name === open);
  // Before there is a drawing there is nothing to set.
  if (groups.length === 0) return null;
  return (
    <Panel title="Groups">
      <ul className="groups">
        {groups.map(({ name, on }) => (
          <li key={name} className={name === open ? "group-row group-open" : "group-row"}>
            <button type="button" className="group-name" onClick={() => setOpen(name)}>
              <span className="swatch" style={{ background: `var(--draw-group-${name})` }} />
              {name}
            </button>
            <span className="group-count">
              {scene.shapes.filter(({ group }) => group === name).length || ""}
            </span>
            <button
              type="button"
              className="link-button"
              disabled={!some}
              onClick={() => desk.send(`group ${name}`)}
              aria-label={`put here: the selection into ${name}`}
            >
              put here
            </button>
            <button
              type="button"
              className="link-button"
              disabled={!some}
              onClick={() => desk.send(`copy-to ${name}`)}
              aria-label={`copy: the selection into ${name}`}
            >
              copy
            </button>
            <label className="group-on">
              <input
                type="checkbox"
                checked={on}
                onChange={() => desk.send(`set ${name} on=${on ? "off" : "on"}`)}
                aria-label={`${name} is cut`}
              />
              cut
            </label>
          </li>
        ))}
      </ul>
      {shown && (
        <GroupForm
          key={`${shown.name} ${units?.linear}`}
          group={shown}
          mm={units?.mm ?? 1}
          desk={desk}
        />
      )}
    </Panel>
  );
}
