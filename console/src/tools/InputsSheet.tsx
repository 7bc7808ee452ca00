import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useFetched } from "../app/useFetched";
import { Sheet } from "../ui/Sheet";
import type { Duty, Lamp } from "../wire/messages";
import { t } from "../words/words";
import "./tools.css";

const duties: Record<Duty, string> = {
  standard: "",
  limit: t("limit switch"),
  stop: t("stops the machine"),
};

/** The switches of a machine whose switches are moved on a page, to be moved by hand: also while a file runs. */
export function InputsSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const inputs = useInputs();
  const press = ({ number, on }: Lamp) =>
    void drive(worldOf(hands), { do: "input", number, on: !on });
  return (
    <Sheet title="Inputs of the machine" shape="side" onClose={onClose}>
      <p className="tool-words">{t("A switch stays as it is put.")}</p>
      <ul className="inputs">
        {inputs.map((lamp) => (
          <li key={lamp.number}>
            <button
              type="button"
              role="switch"
              aria-checked={lamp.on}
              aria-label={t("Input {0}", lamp.number)}
              className="inputs-switch"
              onClick={() => press(lamp)}
            >
              <b>{lamp.number}</b>
              <span>{[lamp.label, duties[lamp.duty]].filter(Boolean).join(", ")}</span>
              <i aria-hidden="true">{lamp.on ? t("on") : t("off")}</i>
            </button>
          </li>
        ))}
      </ul>
    </Sheet>
  );
}

const none: readonly Lamp[] = [];

/** Every input of the machine; the first twelve as they are told. */
function useInputs(): readonly Lamp[] {
  const io = useSnapshot("io");
  const told = io?.inputs ?? [];
  // The lines of the card are told as bits of its ports: whoever closed one must be able to open it again.
  const ports = io?.ports.inputs.join() ?? "";
  const changes = useSnapshot("settings");
  const closed = told.map(({ on }) => on).join();
  const all = useFetched("/api/inputs", none, `${changes} ${closed} ${ports}`);
  return all.length > 0
    ? all.map((lamp) => told.find(({ number }) => number === lamp.number) ?? lamp)
    : told;
}
