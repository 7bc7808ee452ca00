import { useState } from "react";
import { shortText } from "../app/units";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import { type LengthUnit, mm } from "../units/quantity";
import { colourWords } from "../words/operations";
import { t } from "../words/words";
import type { Shape } from "./geometry/shape";
import type { Scene } from "./scene";
import type { Desk } from "./useDesk";

/** Shapes that are listed at once. */
const inSight = 100;

/** The shapes in the order of cutting, to be walked through, selected and erased without seeing the picture. */
export function ShapePanel({ desk, scene }: { desk: Desk; scene: Scene }) {
  const unit = useLengthUnit();
  const [isOpen, setOpen] = useState(false);
  const [most, setMost] = useState(inSight);
  const { shapes, selected } = scene;
  if (shapes.length === 0) return null;
  return (
    <Panel
      title="Shapes"
      aside={
        <Button size="small" look="quiet" aria-expanded={isOpen} onPress={() => setOpen(!isOpen)}>
          {isOpen ? t("Hide") : t("List {0}", shapes.length)}
        </Button>
      }
    >
      {isOpen && (
        <>
          <ul className="shape-list" aria-label={t("Shapes in the order of cutting")}>
            {shapes.slice(0, most).map((shape) => (
              <li key={shape.number}>
                <button
                  type="button"
                  className="list-row"
                  aria-pressed={selected.has(shape.number)}
                  onClick={() =>
                    desk.send(
                      `select ${selected.has(shape.number) ? "remove" : "add"} ${shape.number}`,
                    )
                  }
                  onKeyDown={(event) => {
                    if (event.key !== "Delete") return;
                    event.preventDefault();
                    desk.send(`select ${shape.number}; erase`);
                  }}
                >
                  <span
                    className="swatch"
                    style={{ background: `var(--draw-group-${shape.group})` }}
                  />
                  {wordsOf(shape, unit)}
                </button>
              </li>
            ))}
          </ul>
          {shapes.length > most && (
            <Button size="small" onPress={() => setMost(most + inSight)}>
              {t("More of {0}", shapes.length)}
            </Button>
          )}
          <div className="shape-actions">
            <Button
              size="small"
              refused={selected.size === 0 ? t("Nothing is selected.") : undefined}
              onPress={() => desk.send("erase")}
            >
              Erase the selection
            </Button>
            <Button size="small" onPress={() => desk.send("select none")}>
              Select none
            </Button>
          </div>
        </>
      )}
    </Panel>
  );
}

/** A shape in a line: number, kind, layer, size, place. */
function wordsOf({ number, closed, group, box, vertices }: Shape, unit: LengthUnit): string {
  const text = (value: number) => shortText(mm(value), unit, 3);
  const at = t("at {0}, {1} {2}", text(box.min.x), text(box.min.y), unit.linear);
  if (vertices.length === 1) return t("{0}: point, {1}, {2}", number, group, at);
  const size = `${text(box.max.x - box.min.x)} × ${text(box.max.y - box.min.y)}`;
  return `${number}: ${closed ? t("closed") : t("open")}, ${colourWords(group)}, ${size} ${at}`;
}
