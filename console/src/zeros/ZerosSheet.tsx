import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { locationText } from "../app/units";
import { useBusy } from "../app/useBusy";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { mm } from "../units/quantity";
import type { Zero } from "../wire/messages";
import { t } from "../words/words";
import { shift, takes } from "./take";
import "./zeros.css";

/** The zero points that the controller keeps, each of which can become the zero of what is cut next. */
export function ZerosSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const busy = useBusy();
  const zeros = useSnapshot("zeros") ?? [];
  const axes = (useSnapshot("units")?.axes ?? []).slice(0, 3);
  const take = (zero: Zero) => {
    const machine = hands.link.shown.get().snapshot?.motion.at.machine ?? [];
    void drive(worldOf(hands), { do: "command", line: takes(zero, machine, axes) });
  };
  return (
    <Sheet title={t("Zero points of the controller")} shape="side" onClose={onClose}>
      <p className="zeros-words">
        {t(
          "Whoever sets one at a pendant sees it here. What Kerf cuts goes by its own zero until one is taken.",
        )}
      </p>
      <table className="zeros">
        <thead>
          <tr>
            <th>{t("Name")}</th>
            {axes.map(({ letter, unit }) => (
              <th key={letter}>{`${letter} ${unit}`}</th>
            ))}
            <th />
          </tr>
        </thead>
        <tbody>
          {zeros.map((zero) => (
            <tr key={zero.name}>
              <th scope="row">{zero.name}</th>
              {axes.map((axis, n) => (
                <td key={axis.letter}>{locationText(zero.at[n] ?? mm(0), axis)}</td>
              ))}
              <td>
                {zero.name !== shift && (
                  <Button
                    size="small"
                    refused={busy}
                    aria-label={t("Take {0} as zero", zero.name)}
                    onPress={() => take(zero)}
                  >
                    {t("Take")}
                  </Button>
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </Sheet>
  );
}
