import { useSnapshot } from "../app/context";
import { drawingWords } from "../app/drawingWords";
import { lengthText, numberText } from "../app/units";
import { useLengthUnit } from "../app/useLengthUnit";
import { useWords } from "../app/useWords";
import { Panel } from "../ui/Panel";
import { type LengthUnit, mm } from "../units/quantity";
import { colourWords } from "../words/operations";
import { t } from "../words/words";
import { boxOfShapes, type Shape } from "./geometry/shape";
import { isEmpty } from "./geometry/vec";
import type { Scene } from "./scene";
import type { Desk } from "./useDesk";

interface SelectionPanelProps {
  desk: Desk;
  scene: Scene;
  notes: readonly string[];
}

/** Describes the selection: number of shapes, size, direction; and shows the notes on the drawing. */
export function SelectionPanel({ desk, scene, notes }: SelectionPanelProps) {
  const unit = useLengthUnit();
  const drawing = useSnapshot("drawing");
  const words = useWords();
  const chosen = scene.shapes.filter(({ number }) => scene.selected.has(number));
  const told = [...(drawing?.notes ?? []), ...notes];
  return (
    <Panel
      title={chosen.length > 0 ? t("Selection") : t("Drawing")}
      aside={<Selecting desk={desk} some={chosen.length > 0} />}
    >
      <dl className="facts">
        {factsOf(chosen.length > 0 ? chosen : scene.shapes, unit).map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {told.length > 0 && (
        <ul className="told">
          {told.slice(0, 6).map((note) => (
            <li key={note}>{words(drawingWords(note))}</li>
          ))}
          {told.length > 6 && <li>{t("and {0} more", told.length - 6)}</li>}
        </ul>
      )}
    </Panel>
  );
}

function Selecting({ desk, some }: { desk: Desk; some: boolean }) {
  return (
    <button
      type="button"
      className="link-button"
      onClick={() => desk.send(some ? "select none" : "select all")}
    >
      {some ? t("Select none") : t("Select all")}
    </button>
  );
}

function factsOf(shapes: readonly Shape[], unit: LengthUnit): [string, string][] {
  const box = boxOfShapes(shapes);
  const text = (value: number) => numberText(mm(value), unit);
  const facts: [string, string][] = [[t("Shapes"), String(shapes.length)]];
  if (isEmpty(box)) return facts;
  facts.push([
    t("Size"),
    `${text(box.max.x - box.min.x)} × ${lengthText(mm(box.max.y - box.min.y), unit, 3)}`,
  ]);
  facts.push([t("From"), `${text(box.min.x)}, ${text(box.min.y)}`]);
  const [only] = shapes;
  if (only && shapes.length === 1) facts.push(...factsOfOne(only));
  return facts;
}

function factsOfOne(shape: Shape): [string, string][] {
  const direction = shape.area < 0 ? t("clockwise") : t("counter-clockwise");
  return [
    [t("Number"), String(shape.number)],
    [t("Layer"), colourWords(shape.group)],
    [
      t("Kind"),
      `${shape.closed ? t("closed, {0}", direction) : t("open")}${shape.z ? ", 3D" : ""}`,
    ],
    [t("Vertices"), String(shape.vertices.length)],
  ];
}
