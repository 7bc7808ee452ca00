import { startTool } from "./desk";
import { ToolIcon } from "./ToolIcon";
import { menus, toolsOf } from "./tools/catalog";
import type { Tool } from "./tools/tool";
import type { Desk } from "./useDesk";
import "./toolbox.css";

/** Every tool, by menu. */
export function Toolbox({ desk }: { desk: Desk }) {
  return (
    <nav className="toolbox" aria-label="Drawing tools">
      {menus.map(({ menu, title }) => (
        <section key={menu} aria-label={title}>
          <h2>{title}</h2>
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
      <span>{tool.title}</span>
    </button>
  );
}
