import { useState } from "react";
import { drive } from "../actions/ask";
import { unlessReady } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { locationText, usedAxes } from "../app/units";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { mm } from "../units/quantity";
import type { Zero, ZeroChange } from "../wire/messages";
import { t } from "../words/words";
import { ZeroForm } from "./ZeroForm";
import "./zeros.css";

/** The shift of all zero points, which can be taken away. */
const shift = "G92";
const isShift = ({ name }: Zero) => name === shift || name === "TLO";

/** The zero points that the controller keeps: seen, set, and the one chosen that holds. */
export function ZerosSheet({ onClose }: { onClose: () => void }) {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const zeros = useSnapshot("zeros") ?? [];
  const units = useSnapshot("units");
  const [name, setName] = useState<string>();
  if (!units) return null;
  const change = (name: string, change: ZeroChange) =>
    void drive(worldOf(hands), { do: "zero", name, change });
  const places = zeros.filter((zero) => !isShift(zero));
  const holding = places.find(({ holds }) => holds) ?? places[0];
  return (
    <Sheet title={t("Zero points of the controller")} shape="side" onClose={onClose}>
      <p className="zeros-words">
        {t(
          "The zero of what Kerf cuts follows the one that holds when it is set or chosen here. One that is set at a pendant is seen here, and followed when it is chosen.",
        )}
      </p>
      <Zeros {...{ zeros, refused, change }} />
      {holding && (
        <ZeroForm
          names={places.map(({ name }) => name)}
          name={name ?? holding.name}
          axes={usedAxes(units)}
          {...{ units, refused, change, setName }}
        />
      )}
    </Sheet>
  );
}

interface ZerosProps {
  zeros: readonly Zero[];
  refused: string | undefined;
  change: (name: string, change: ZeroChange) => void;
}

function Zeros({ zeros, refused, change }: ZerosProps) {
  const axes = (useSnapshot("units")?.axes ?? []).slice(0, 3);
  return (
    <table className="zeros">
      <thead>
        <tr>
          <th>{t("Name")}</th>
          {axes.map(({ letter, unit }) => (
            <th key={letter}>{`${letter} ${unit}`}</th>
          ))}
          <td />
        </tr>
      </thead>
      <tbody>
        {zeros.map((zero) => (
          <tr key={zero.name} aria-current={zero.holds && !isShift(zero) ? "true" : undefined}>
            <th scope="row">
              {zero.name}
              {zero.holds && !isShift(zero) && <em>{t("holds")}</em>}
            </th>
            {axes.map((axis, n) => (
              <td key={axis.letter}>{locationText(zero.at[n] ?? mm(0), axis)}</td>
            ))}
            <td>
              {!isShift(zero) && (
                <Button
                  size="small"
                  refused={refused}
                  aria-label={t("Use {0}", zero.name)}
                  onPress={() => change(zero.name, { to: "holds" })}
                >
                  {t("Use")}
                </Button>
              )}
              {zero.name === shift && (
                <Button
                  size="small"
                  refused={refused}
                  aria-label={t("Clear {0}", zero.name)}
                  onPress={() => change(zero.name, { to: "gone" })}
                >
                  {t("Clear")}
                </Button>
              )}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
