import { t } from "../words/words";
import { type DeskKey, type KeyMenu, keysIn } from "./keys";
import type { Desk } from "./useDesk";

interface KeyButtonsProps {
  desk: Desk;
  menu: KeyMenu;
  /** The key that is in force. */
  pressed?: string | null;
  after: () => void;
}

const names: Record<string, string> = {
  arrowleft: "←",
  arrowright: "→",
  arrowup: "↑",
  arrowdown: "↓",
  enter: t("Enter"),
  escape: t("Esc"),
  delete: t("Del"),
};

const nameOf = ({ key }: DeskKey): string => names[key] ?? key.toUpperCase();

/** The keys of a menu that mean something now, as buttons: everything a key does the mouse does too. */
export function KeyButtons({ desk, menu, pressed = null, after }: KeyButtonsProps) {
  const keys = keysIn(menu).filter((key) => key.press(desk.state, desk.around) !== null);
  return keys.map((key) => (
    <button
      key={key.key}
      type="button"
      className="key-button"
      data-key={key.key}
      aria-pressed={menu === "snap" ? pressed === key.key : undefined}
      title={`${key.title} (${nameOf(key)})`}
      aria-label={key.title}
      onClick={() => {
        desk.act(key.press);
        after();
      }}
    >
      {menu === "window" ? <WindowIcon sign={key.sign} /> : key.sign}
    </button>
  ));
}

const windowPaths: Record<string, string> = {
  in: "M8 3v10M3 8h10",
  out: "M3 8h10",
  centre: "M8 1v4M8 11v4M1 8h4M11 8h4M8 5a3 3 0 1 0 .01 0",
  all: "M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4",
};

const WindowIcon = ({ sign }: { sign: string }) => (
  <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" className="tool-icon">
    <path d={windowPaths[sign]} />
  </svg>
);
