import { useState } from "react";
import { drive } from "../actions/ask";
import { whenIdle } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { placeText } from "../app/units";
import { useLengthUnit } from "../app/useLengthUnit";
import { readFile, writeFile } from "../link/http";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import type { HeightMapChange } from "../wire/messages";
import { t } from "../words/words";
import { HeightPicture } from "./HeightPicture";
import { fileText, placesOf, rangeText } from "./heights";

/** The map in force, and files of heights: used, kept, taken off. */
export function InForce() {
  const hands = useHands();
  const { link, screen } = hands;
  const map = useSnapshot("heightMap");
  const unit = useLengthUnit();
  const refused = useShown((shown) => whenIdle({ shown, link, screen }));
  const [name, setName] = useState("heights.map");
  const change = (to: HeightMapChange) =>
    void drive(worldOf(hands), { do: "heightMap", change: to });
  const keep = async () => {
    try {
      const replaces = await readFile(name).then(
        ({ hash }) => hash,
        () => null,
      );
      await writeFile(name, fileText(map ? placesOf(map) : []), replaces);
      screen.tell(t("{0} is written.", name));
    } catch (error) {
      screen.tell((error as Error).message);
    }
  };
  return (
    <section className="height-map-force" aria-label={t("Height map in force")}>
      <p role="status">
        {map
          ? t("Height map: on, {0}", rangeText(map.lowest, map.highest, unit))
          : t("No height map is in force: surfaces are flat.")}
      </p>
      {map && (
        <p>
          {t(
            "{0} by {1} places, from {2} to {3}",
            map.columns,
            map.rows,
            placeText(map.low, unit),
            placeText(map.high, unit),
          )}
        </p>
      )}
      {map && map.zs.length > 0 && <HeightPicture places={placesOf(map)} />}
      <div className="height-map-file">
        <Field label="File of heights" value={name} onChange={setName} />
        <Button refused={refused} onPress={() => change({ to: "file", name })}>
          Use it
        </Button>
        {map && map.zs.length > 0 && <Button onPress={() => void keep()}>Keep as file</Button>}
        {map && (
          <Button refused={refused} onPress={() => change({ to: "off" })}>
            Take the map off
          </Button>
        )}
      </div>
    </section>
  );
}
