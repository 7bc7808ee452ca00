import type { FoundBoard, FoundPort } from "../wire/messages";
import { serverWords } from "../words/server";
import { t } from "../words/words";

interface PortsProps {
  found: readonly FoundPort[];
  /** The port that is chosen. */
  port: string;
  onChoose: (port: string) => void;
}

/** Ports that were looked at, with who is at each: boards can be chosen. */
export function Ports({ found, port, onChoose }: PortsProps) {
  if (found.length === 0) return null;
  return (
    <fieldset className="wiring-ports">
      <legend>{t("Ports of this computer")}</legend>
      {found.map((it) => (
        <label key={it.port} className="wiring-port">
          <input
            type="radio"
            name="wiring-port"
            checked={it.port === port}
            disabled={it.board === null}
            onChange={() => onChoose(it.port)}
          />
          <span>
            <span className="wiring-path">{it.port}</span>
            {it.device && <span className="wiring-about">{it.device}</span>}
            <span className="wiring-about">
              {it.board ? who(it.board) : serverWords(it.trouble ?? "")}
            </span>
          </span>
        </label>
      ))}
    </fieldset>
  );
}

/** A board in a sentence. */
function who({ chip, firmware, isConfigured, isShutDown }: FoundBoard): string {
  const is = t("{0}, firmware {1}", chip, firmware);
  if (isShutDown) return `${is}; ${t("shut down: reset it")}`;
  return isConfigured ? `${is}; ${t("wired since it was powered: reset it for other pins")}` : is;
}
