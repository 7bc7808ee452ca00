import { useSnapshot } from "../app/context";
import { useWords } from "../app/useWords";
import { Panel } from "../ui/Panel";
import { boxOfShapes, type Shape } from "./geometry/shape";
import { isEmpty } from "./geometry/vec";
import type { Scene } from "./scene";
import type { Desk } from "./useDesk";

interface SelectionPanelProps {
  desk: Desk;
  scene: Scene;
  notes: readonly string[];
}

/** What is selected: how many, how large, which way; and what the drawing has to tell. */
export function SelectionPanel({ desk, scene, notes }: SelectionPanelProps) {
  const units = useSnapshot("units");
  const drawing = useSnapshot("drawing");
  const words = useWords();
  const [mm, unit] = [units?.mm ?? 1, units?.linear ?? "mm"];
  const chosen = scene.shapes.filter(({ number }) => scene.selected.has(number));
  const told = [...(drawing?.notes ?? []), ...notes];
  return (
    <Panel
      title={chosen.length > 0 ? "Selection" : "Drawing"}
      aside={<Selecting desk={desk} some={chosen.length > 0} />}
    >
      <dl className="facts">
        {factsOf(chosen.length > 0 ? chosen : scene.shapes, mm, unit).map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {told.length > 0 && (
        <ul className="told">
          {told.slice(0, 6).map((note) => (
            <li key={note}>{words(note)}</li>
          ))}
          {told.length > 6 && <li>and {told.length - 6} more</li>}
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
      {some ? "Select none" : "Select all"}
    </button>
  );
}

function factsOf(shapes: readonly Shape[], mm: number, unit: string): [string, string][] {
  const box = boxOfShapes(shapes);
  const text = (value: number) => (value / mm).toFixed(3);
  const facts: [string, string][] = [["Shapes", String(shapes.length)]];
  if (isEmpty(box)) return facts;
  facts.push(["Size", `${text(box.max.x - box.min.x)} × ${text(box.max.y - box.min.y)} ${unit}`]);
  facts.push(["From", `${text(box.min.x)}, ${text(box.min.y)}`]);
  const [only] = shapes;
  if (only && shapes.length === 1) facts.push(...factsOfOne(only));
  return facts;
}

function factsOfOne(shape: Shape): [string, string][] {
  const direction = shape.area < 0 ? "clockwise" : "counter-clockwise";
  return [
    ["Number", String(shape.number)],
    ["Group", shape.group],
    ["Kind", `${shape.closed ? `closed, ${direction}` : "open"}${shape.z ? ", 3D" : ""}`],
    ["Vertices", String(shape.vertices.length)],
  ];
}
