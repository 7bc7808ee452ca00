import { type MouseEvent, useEffect, useMemo, useRef, useState } from "react";
import { openTiming } from "../actions/go";
import { useHands, useScreen, useShown, useSnapshot, worldOf } from "../app/context";
import { lengthText } from "../app/units";
import { useLengthUnit } from "../app/useLengthUnit";
import { paintDigitized } from "../digitize/paint";
import { type DigitizedItem, digitizedItem, lookedAt } from "../digitize/points";
import { useLook } from "../digitize/useLook";
import { type Box, isEmpty, joined, type Place, place } from "../draw/geometry/vec";
import { inkOf, pixelOf } from "../draw/ink";
import { paintPaper } from "../draw/paint/paper";
import { sheetOn } from "../draw/paint/pen";
import { paintTable } from "../draw/paint/table";
import type { TableItem } from "../draw/table";
import {
  expansionFactor,
  fitted,
  panned,
  toDrawing,
  usualExpansion,
  type Window,
  zoomedAbout,
} from "../draw/window";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { mm } from "../units/quantity";
import { useSize } from "../view/useSize";
import { colourWords } from "../words/operations";
import { phrase, t } from "../words/words";
import { chooseStart } from "./actions";
import { paintPlan, paintProgress } from "./paint";
import { margin, type Plan, pathAt, type Standing, toolPlace } from "./plan";

/** A click picks what lies so near, pixels. */
const near = 10;

/** A press that moves further than this moves the sheet, pixels. */
const still = 4;

interface JobSheetProps {
  plan: Plan;
  standing: Standing;
}

/** The paths of the job; a click on one begins the job with it. */
export function JobSheet({ plan, standing }: JobSheetProps) {
  const hands = useHands();
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box);
  const [wanted, setWindow] = useState<Window | null>(null);
  const [hover, setHover] = useState<number | null>(null);
  const pressed = useRef<{ at: Place; window: Window } | null>(null);
  const all = useMemo(() => boxOf(plan), [plan]);
  const { width, height } = size;
  // biome-ignore lint/correctness/useExhaustiveDependencies: shows all of another job, not of each choice
  useEffect(() => {
    if (width > 0) setWindow(fitted(all, { width, height }, margin));
  }, [plan.paths.length, width, height]);
  const window = wanted ?? fitted(all, size, margin);
  const digitized = useSnapshot("digitized");
  const points = useMemo(() => (digitized ? digitizedItem(digitized) : null), [digitized]);
  const expansion = expansionFactor(useSnapshot("setup")?.windowExpansion ?? usualExpansion);
  useLook((look) => {
    const seen = { window, size, data: plan.box, points, machine: boundsOf(plan), expansion };
    setWindow(lookedAt(look, seen));
  });
  const found = (event: MouseEvent) =>
    pathAt(plan, toDrawing(window, size, pixelOf(box.current, event)), near * window.mmPerPixel);
  return (
    <div className="job-sheet-box">
      <div
        ref={box}
        className={hover === null ? "job-sheet" : "job-sheet job-sheet-picking"}
        role="application"
        aria-label={t("Paths of the job")}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          pressed.current = { at: pixelOf(box.current, event), window };
        }}
        onPointerMove={(event) => {
          const from = pressed.current;
          const at = pixelOf(box.current, event);
          if (!from) return setHover(found(event));
          const [across, down] = [at.x - from.at.x, at.y - from.at.y];
          if (Math.hypot(across, down) > still) setWindow(panned(from.window, across, down));
        }}
        onPointerUp={(event) => {
          const from = pressed.current;
          pressed.current = null;
          const at = pixelOf(box.current, event);
          if (!from || Math.hypot(at.x - from.at.x, at.y - from.at.y) > still) return;
          const number = found(event);
          if (number !== null) void chooseStart(worldOf(hands), number);
        }}
        onPointerLeave={() => setHover(null)}
        onWheel={(event) => {
          const at = toDrawing(window, size, pixelOf(box.current, event));
          setWindow(zoomedAbout(window, at, Math.exp(-event.deltaY / 500)));
        }}
      >
        <Canvases {...{ plan, standing, window, hover, points }} size={size} />
      </div>
      <div className="job-sheet-bar">
        <Button size="small" onPress={() => setWindow(fitted(all, size, margin))}>
          Show all
        </Button>
        <ActionButton action={openTiming} size="small">
          Timing
        </ActionButton>
        <Legend plan={plan} />
        <HoverWords plan={plan} number={hover} />
      </div>
    </div>
  );
}

/** All paths, the origin and where the head goes at the end. */
function boxOf({ box, view }: Plan) {
  const [x, y] = view.finish;
  const spots = {
    min: place(Math.min(0, x), Math.min(0, y)),
    max: place(Math.max(0, x), Math.max(0, y)),
  };
  return isEmpty(box) ? spots : joined(box, spots);
}

interface CanvasesProps extends JobSheetProps {
  window: Window;
  size: { width: number; height: number };
  hover: number | null;
  points: DigitizedItem | null;
}

function Canvases({ plan, standing, window, size, hover, points }: CanvasesProps) {
  const [base, over] = [useRef<HTMLCanvasElement>(null), useRef<HTMLCanvasElement>(null)];
  const theme = useScreen("theme");
  const unit = useLengthUnit();
  const motion = useSnapshot("motion");
  const snapshot = useShown((shown) => shown.snapshot);
  const { start } = standing;
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme changes the inks
  useEffect(() => {
    const sheet = base.current && sheetOn(base.current, window, size);
    if (!sheet) return;
    const ink = inkOf(sheet.pen.canvas);
    paintPaper(sheet, unit, ink);
    paintPlan(sheet, plan, { runs: false, at: 0, start, finished: false }, ink);
  }, [plan, start, window, size.width, size.height, unit, theme]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme changes the inks
  useEffect(() => {
    const sheet = over.current && sheetOn(over.current, window, size);
    if (!sheet) return;
    const { pen } = sheet;
    pen.clearRect(0, 0, size.width, size.height);
    const ink = inkOf(pen.canvas);
    paintProgress(sheet, plan, standing, { hover, ink });
    paintDigitized(sheet, points, ink);
    paintTable(sheet, spots(plan, toolPlace(snapshot, plan)), ink);
  }, [plan, standing, hover, points, motion, window, size.width, size.height, theme]);
  return (
    <>
      <canvas ref={base} className="sheet-canvas" />
      <canvas ref={over} className="sheet-canvas" />
    </>
  );
}

/** Box that the axes reach, from the job's origin; nothing without bounds. */
function boundsOf({ view }: Pick<Plan, "view">): Box | null {
  const [[x0, y0], [[left, right], [bottom, top]]] = [view.origin, view.table];
  const box = { min: place(left - x0, bottom - y0), max: place(right - x0, top - y0) };
  return right > left && top > bottom ? box : null;
}

/** The machine round the job, from its origin. */
function spots({ view }: Plan, tool: Place | null): TableItem[] {
  const [[x0, y0], [fx, fy]] = [view.origin, view.finish];
  const bounds = boundsOf({ view });
  return [
    ...(bounds ? [{ kind: "bounds" as const, box: bounds }] : []),
    { kind: "home", at: place(-x0, -y0) },
    { kind: "origin", at: place(0, 0) },
    { kind: "finish", at: place(fx, fy) },
    ...(tool ? [{ kind: "tool" as const, at: tool }] : []),
  ];
}

/** The groups that have paths, in their colours. */
function Legend({ plan }: { plan: Plan }) {
  return (
    <ul className="job-legend" aria-label={t("Layers")}>
      {plan.groups.map((group) => (
        <li key={group}>
          <i style={{ background: `var(--draw-group-${group})` }} aria-hidden="true" />
          {colourWords(group)}
        </li>
      ))}
    </ul>
  );
}

/** Describes the path under the pointer. */
function HoverWords({ plan, number }: { plan: Plan; number: number | null }) {
  const units = useSnapshot("units");
  const path = plan.paths[(number ?? 0) - 1];
  if (number === null || !path || !units)
    return <p className="job-hover">{t("A click on a path begins the job with it.")}</p>;
  const { box, group } = path.shape;
  const [wide, high] = [mm(box.max.x - box.min.x), mm(box.max.y - box.min.y)];
  return (
    <p className="job-hover">
      {phrase(
        "{0}, {1}, tool {2}, {3} × {4}",
        <b>{t("Path {0}", number)}</b>,
        colourWords(group),
        path.tool,
        lengthText(wide, units),
        lengthText(high, units),
      )}
    </p>
  );
}
