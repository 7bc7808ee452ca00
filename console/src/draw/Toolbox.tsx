import { t } from "../words/words";
import { startTool } from "./desk";
import { ToolIcon } from "./ToolIcon";
import { menus, toolsOf } from "./tools/catalog";
import type { Tool } from "./tools/tool";
import type { Desk } from "./useDesk";
import "./toolbox.css";

interface ToolboxProps {
  desk: Desk;
  /** Opens the sheet of an operation; blank is the list of all. */
  onOperation: (name: string) => void;
}

/** Operations that are wanted often and have no tool for the hand. */
const sheets: readonly { readonly name: string; readonly title: string; readonly doc: string }[] = [
  { name: "engrave", title: t("Engrave…"), doc: t("Clears areas ring by ring") },
  { name: "pocket", title: t("Pocket…"), doc: t("Clears areas in rings or in lines") },
  { name: "array", title: t("Array…"), doc: t("Of shapes, of the drawing, of the whole job") },
  { name: "sequence", title: t("Order…"), doc: t("By travel, by layers, by levels") },
  { name: "set", title: t("Settings…"), doc: t("Offset, leads, tab, depth, plunge of a layer") },
  { name: "justify", title: t("Justify…"), doc: t("The drawing at the origin") },
];

/** Sheets of operations, then every tool by menu. */
export function Toolbox({ desk, onOperation }: ToolboxProps) {
  return (
    <nav className="toolbox" aria-label={t("Drawing tools")}>
      <section aria-label={t("Operations")}>
        <h2>{t("Operations")}</h2>
        <div className="toolbox-tools">
          {sheets.map(({ name, title, doc }) => (
            <button
              key={name}
              type="button"
              className="tool-button"
              title={doc}
              onClick={() => onOperation(name)}
            >
              <ToolIcon id={name} />
              <span>{t(title)}</span>
            </button>
          ))}
          <button
            type="button"
            className="tool-button toolbox-more"
            onClick={() => onOperation("")}
          >
            <ToolIcon id="all" />
            <span>{t("All operations…")}</span>
          </button>
        </div>
      </section>
      {menus.map(({ menu, title }) => (
        <section key={menu} aria-label={title}>
          <h2>{t(title)}</h2>
          <div className="toolbox-tools">
            {toolsOf(menu).map((tool) => (
              <ToolButton key={tool.id} tool={tool} desk={desk} />
            ))}
          </div>
        </section>
      ))}
    </nav>
  );
}

function ToolButton({ tool, desk }: { tool: Tool; desk: Desk }) {
  const active = desk.state.running?.tool.id === tool.id;
  return (
    <button
      type="button"
      className="tool-button"
      aria-pressed={active}
      title={tool.doc}
      onClick={() => desk.act((state, around) => startTool(state, tool, around))}
    >
      <ToolIcon id={tool.id} />
      <span>{t(tool.title)}</span>
    </button>
  );
}
