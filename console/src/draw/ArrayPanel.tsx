import { useSnapshot } from "../app/context";
import { lengthText } from "../app/units";
import { Button } from "../ui/Button";
import { Panel } from "../ui/Panel";
import type { Mm } from "../units/quantity";
import type { ArrayState, Units } from "../wire/messages";
import { t } from "../words/words";
import { corners, orders, repeats } from "./arrays";

/** The grid and pitch in which the drawing is repeated; nothing where it is cut once. */
export function ArrayPanel({ onChange }: { onChange: () => void }) {
  const arrays = useSnapshot("drawing")?.arrays ?? [];
  const units = useSnapshot("units");
  const shown = arrays.filter(repeats);
  if (shown.length === 0 || !units) return null;
  return (
    <Panel
      title="Arrays"
      aside={
        <Button size="small" onPress={onChange}>
          Change…
        </Button>
      }
    >
      <dl className="array-levels">
        {shown.map((array) => (
          <Level key={array.level} array={array} units={units} />
        ))}
      </dl>
    </Panel>
  );
}

function Level({ array: { level, grid, gap, pitch, start, order }, units }: LevelProps) {
  const [rows, columns] = grid;
  const length = (one: Mm) => lengthText(one, units, 3);
  return (
    <div data-level={level}>
      <dt>
        {level === "block" ? t("Blocks in a job") : t("Jobs on the table")}: {rows} × {columns}
      </dt>
      <dd>{t("Pitch: X {0}, Y {1}", length(pitch[0]), length(pitch[1]))}</dd>
      <dd>{t("Gap: X {0}, Y {1}", length(gap[0]), length(gap[1]))}</dd>
      <dd>{t("Begins {0}, {1}", corners[start] ?? start, orders[order] ?? order)}</dd>
    </div>
  );
}

interface LevelProps {
  array: ArrayState;
  units: Units;
}
