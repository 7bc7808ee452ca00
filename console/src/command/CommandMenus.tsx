import { Menu, MenuItem, MenuTrigger, Popover } from "react-aria-components";
import { useHands, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import type { CommandEntry } from "../wire/messages";
import { t } from "../words/words";
import "./command-menus.css";
import { execute } from "./execute";
import { inMenu, menus, useCommands } from "./table";

/** The menus of the FULL face; choosing a command is as typing it. */
export function CommandMenus() {
  const table = useCommands();
  return (
    <nav className="menus" aria-label={t("Commands")}>
      {menus.map(({ group, title }) => (
        <CommandMenu key={group} title={title} entries={inMenu(table, group)} />
      ))}
    </nav>
  );
}

function CommandMenu({ title, entries }: { title: string; entries: readonly CommandEntry[] }) {
  const hands = useHands();
  const choose = (letters: string) => {
    const entry = entries.find((one) => one.letters === letters);
    if (entry && entry.parameters.length > 0) {
      hands.screen.open({ kind: "command", letters, given: [] });
    } else execute(worldOf(hands), letters);
  };
  return (
    <MenuTrigger>
      <Button size="small" look="quiet">
        {title}
      </Button>
      <Popover className="menu-popover" placement="top start" isNonModal>
        <Menu className="menu" aria-label={title} onAction={(key) => choose(String(key))}>
          {entries.map((entry) => (
            <MenuItem key={entry.letters} id={entry.letters} className="menu-item">
              <span title={entry.doc}>
                <b>{entry.letters}</b> {entry.name}
              </span>
            </MenuItem>
          ))}
        </Menu>
      </Popover>
    </MenuTrigger>
  );
}
