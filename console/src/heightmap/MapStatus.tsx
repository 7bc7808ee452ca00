import { useHands, useSnapshot } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { t } from "../words/words";
import { rangeText } from "./heights";
import "./height-map.css";

/** Says that a height map is followed, and leads to it. */
export function MapStatus() {
  const { screen } = useHands();
  const map = useSnapshot("heightMap");
  const unit = useLengthUnit();
  if (!map) return null;
  return (
    <button
      type="button"
      className="height-map-status"
      onClick={() => screen.open({ kind: "heightMap" })}
    >
      {t("Height map: on, {0}", rangeText(map.lowest, map.highest, unit))}
    </button>
  );
}
