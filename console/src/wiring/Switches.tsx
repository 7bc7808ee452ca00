import type { WiredSwitch } from "../wire/messages";
import { t } from "../words/words";

/** Switches of the board as they are now: whoever presses one sees it change. */
export function Switches({ switches }: { switches: readonly WiredSwitch[] }) {
  if (switches.length === 0) return null;
  return (
    <section className="wiring-switches" aria-label={t("Switches now")}>
      <h3>{t("Switches now")}</h3>
      <ul>
        {switches.map(({ about, pin, on }) => (
          <li key={`${about} ${pin}`} data-on={on}>
            <span>
              {/^\d/.test(about) ? t("Input {0}", about) : t("Home switch of {0}", about)}
            </span>
            <code>{pin}</code>
            <b>{on ? t("pressed") : t("open")}</b>
          </li>
        ))}
      </ul>
    </section>
  );
}
