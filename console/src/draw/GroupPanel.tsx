import { useState } from "react";
import { useSnapshot } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { Panel } from "../ui/Panel";
import { colourWords } from "../words/operations";
import { t } from "../words/words";
import { GroupForm } from "./GroupForm";
import type { Scene } from "./scene";
import type { Desk } from "./useDesk";

interface GroupPanelProps {
  desk: Desk;
  scene: Scene;
}

/** The eight layers, those without shapes when asked for: how many shapes, whether they are cut, how. */
export function GroupPanel({ desk, scene }: GroupPanelProps) {
  const groups = useSnapshot("drawing")?.groups ?? [];
  const unit = useLengthUnit();
  const [open, setOpen] = useState<string | null>(null);
  const [all, setAll] = useState(false);
  const some = scene.selected.size > 0;
  const shown = groups.find(({ name }) => name === open);
  // Before there is a drawing there is nothing to set.
  if (groups.length === 0) return null;
  const countOf = (name: string) => scene.shapes.filter(({ group }) => group === name).length;
  // What is selected can go to any of them.
  const isSeen = (name: string, on: boolean) =>
    all || some || !on || name === open || countOf(name) > 0 || name === "black";
  const rows = groups.filter(({ name, on }) => isSeen(name, on));
  return (
    <Panel
      title="Layers"
      aside={
        rows.length < groups.length || all ? (
          <button type="button" className="link-button" onClick={() => setAll(!all)}>
            {all ? t("Used layers") : t("All {0}", groups.length)}
          </button>
        ) : null
      }
    >
      <ul className="groups">
        {rows.map(({ name, on }) => (
          <li key={name} className={name === open ? "group-row group-open" : "group-row"}>
            <button
              type="button"
              className="group-name list-row"
              aria-expanded={name === open}
              onClick={() => setOpen(name === open ? null : name)}
            >
              <span className="swatch" style={{ background: `var(--draw-group-${name})` }} />
              {colourWords(name)}
            </button>
            <span className="group-count">{countOf(name) || ""}</span>
            <button
              type="button"
              className="link-button"
              disabled={!some}
              onClick={() => desk.send(`group ${name}`)}
              title={t("Moves the selection to the layer {0}", colourWords(name))}
              aria-label={t("move: the selection into {0}", colourWords(name))}
            >
              {t("move")}
            </button>
            <button
              type="button"
              className="link-button"
              disabled={!some}
              onClick={() => desk.send(`copy-to ${name}`)}
              aria-label={t("copy: the selection into {0}", colourWords(name))}
            >
              {t("copy")}
            </button>
            <label className="group-on">
              <input
                type="checkbox"
                checked={on}
                onChange={() => desk.send(`set ${name} on=${on ? "off" : "on"}`)}
                aria-label={t("{0} is cut", colourWords(name))}
              />
              {t("cut")}
            </label>
          </li>
        ))}
      </ul>
      {shown && (
        <GroupForm key={`${shown.name} ${unit.linear}`} group={shown} unit={unit} desk={desk} />
      )}
    </Panel>
  );
}
