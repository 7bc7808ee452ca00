import {
  type KeyboardEvent,
  type PointerEvent,
  type ReactNode,
  useEffect,
  useMemo,
  useRef,
} from "react";
import { useScreen, useSnapshot } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { paintDigitized } from "../digitize/paint";
import { lookedAt } from "../digitize/points";
import { useLook } from "../digitize/useLook";
import { type LengthUnit, type Mm, mm } from "../units/quantity";
import { useSize } from "../view/useSize";
import { t } from "../words/words";
import { Chooser } from "./Chooser";
import { chordOf } from "./chords";
import { dragged, grabbed, moved, pressed, released, rightClicked } from "./desk";
import { EntryBox } from "./EntryBox";
import { boxOf, type Place, place } from "./geometry/vec";
import { overlayOf } from "./ghost";
import { inkOf, pixelOf } from "./ink";
import { isDeskKey, typed } from "./keys";
import { paintOverlay } from "./paint/overlay";
import { paintPaper } from "./paint/paper";
import { sheetOn } from "./paint/pen";
import { paintPicture } from "./paint/picture";
import { paintTable } from "./paint/table";
import { pictureOf } from "./picture";
import { StatusBar } from "./StatusBar";
import type { Scene } from "./scene";
import { boundsOf, inDrawing, originOf, type TableItem, tableItems } from "./table";
import type { Desk } from "./useDesk";
import { fitted, type Size, toDrawing, zoomedAbout } from "./window";
import "./drawing-sheet.css";

interface DrawingSheetProps {
  desk: Desk;
  scene: Scene;
  /** Of the shapes that are loaded. */
  revision: number;
  children?: ReactNode;
}

/** The shapes, and the hands that change them. */
export function DrawingSheet({ desk, scene, revision, children }: DrawingSheetProps) {
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box);
  useWindow(desk, scene, revision, size);
  const [motion, reach] = [useSnapshot("motion"), useSnapshot("setup")?.reach];
  useLook((look) => {
    const machine = motion && reach ? boundsOf(motion, reach) : null;
    desk.set((state) => {
      const { window, size } = state;
      const { expansion } = desk.around;
      const points = scene.digitized;
      const seen = { window, size, data: scene.box, points, machine, expansion };
      return { ...state, window: lookedAt(look, seen) };
    });
  });
  const { running, entry } = desk.state;
  // Keys of the drawing are heard as soon as a tool is taken.
  useEffect(() => {
    if (running && entry === null) box.current?.focus();
  }, [running, entry]);
  const unit = useLengthUnit();
  const place = (event: { clientX: number; clientY: number }) =>
    toDrawing(desk.state.window, size, pixelOf(box.current, event));
  return (
    <section className="sheet-panel" aria-label={t("Sheet")}>
      <div
        ref={box}
        className={classOf(desk)}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the drawing is worked on with keys
        tabIndex={0}
        role="application"
        aria-label={t("Shapes of the drawing")}
        onKeyDown={(event) => keyed(desk, event, unit)}
        onPointerDown={(event) =>
          pointerDown(desk, event, place(event), pixelOf(box.current, event))
        }
        onPointerMove={(event) =>
          desk.set((state) => moved(state, place(event), pixelOf(box.current, event)))
        }
        onPointerUp={(event) => {
          if (event.button === 2) return;
          const [{ drag }, adds] = [desk.set(released), event.shiftKey];
          desk.act((state, around) => dragged(state, drag, adds, around));
        }}
        onPointerLeave={() => desk.set((state) => ({ ...state, pointer: null }))}
        onContextMenu={(event) => {
          event.preventDefault();
          desk.act(rightClicked);
        }}
        onWheel={(event) => {
          const at = place(event);
          const factor = Math.exp(-event.deltaY / 500);
          desk.set((state) => ({ ...state, window: zoomedAbout(state.window, at, factor) }));
        }}
      >
        <Canvases desk={desk} scene={scene} unit={unit} />
      </div>
      <EntryBox desk={desk} size={size} unit={unit} onDone={() => box.current?.focus()} />
      <Chooser desk={desk} scene={scene} size={size} />
      {children}
      <StatusBar desk={desk} unit={unit} onPress={() => box.current?.focus()} />
    </section>
  );
}

/** The cursor tells that something is to be picked, or that a click waits for its turn. */
const classOf = ({ state, waits }: Desk): string =>
  ["sheet-box", state.running ? "sheet-picking" : "", waits ? "sheet-waits" : ""].join(" ").trim();

/** Area that a new drawing shows, mm: the corner of a table at its origin. */
const corner = boxOf(place(-10, -10), place(300, 200));

/** Follows the size of the picture, and shows all of a drawing as soon as the shapes of it are loaded. */
function useWindow(desk: Desk, scene: Scene, revision: number, { width, height }: Size): void {
  const drawing = useSnapshot("drawing");
  const begun = drawing?.begun ?? 0;
  const here = begun === 0 || revision >= begun;
  const opened = (drawing?.name ?? null) !== null && scene.shapes.length > 0;
  // biome-ignore lint/correctness/useExhaustiveDependencies: fits what was opened, not every change
  useEffect(() => {
    const size = { width, height };
    const { expansion } = desk.around;
    const window = opened ? fitted(scene.box, size, expansion) : fitted(corner, size);
    if (width > 0) desk.set((state) => ({ ...state, size, window }));
  }, [begun, here, width > 0]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: only when the picture's size changes
  useEffect(() => {
    desk.set((state) => ({ ...state, size: { width, height } }));
  }, [width, height]);
}

type CanvasesProps = Pick<DrawingSheetProps, "desk" | "scene"> & { unit: LengthUnit };

function Canvases({ desk, scene, unit }: CanvasesProps) {
  const [base, over] = [useRef<HTMLCanvasElement>(null), useRef<HTMLCanvasElement>(null)];
  const theme = useScreen("theme");
  const { window, size } = desk.state;
  const picture = useMemo(() => pictureOf(scene), [scene]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme changes the inks
  useEffect(() => {
    const sheet = base.current && sheetOn(base.current, window, size);
    if (!sheet) return;
    const ink = inkOf(sheet.pen.canvas);
    paintPaper(sheet, unit, ink);
    paintPicture(sheet, picture, ink);
  }, [picture, window, size, unit, theme]);
  const table = useTable(scene.options.machine);
  const overlay = useMemo(() => overlayOf(desk.state, desk.around), [desk.state, desk.around]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme changes the inks
  useEffect(() => {
    const sheet = over.current && sheetOn(over.current, window, size);
    if (!sheet) return;
    const ink = inkOf(sheet.pen.canvas);
    paintOverlay(sheet, overlay, ink);
    paintDigitized(sheet, scene.digitized, ink);
    paintTable(sheet, table, ink);
  }, [overlay, table, scene.digitized, window, size, theme]);
  return (
    <>
      <canvas ref={base} className="sheet-canvas" />
      <canvas ref={over} className="sheet-canvas" />
    </>
  );
}

const noTable: readonly TableItem[] = [];
const noReach: [Mm, Mm] = [mm(0), mm(0)];

/** The machine round the drawing, where it is wanted. */
function useTable(wanted: boolean): readonly TableItem[] {
  const motion = useSnapshot("motion");
  const reach = useSnapshot("setup")?.reach;
  const finish = useSnapshot("drawing")?.finish;
  return useMemo(() => {
    if (!wanted || !motion) return noTable;
    const [origin, { machine }] = [originOf(motion), motion.at];
    const [x, y] = finish ?? [0, 0];
    const tool = place(machine[0], machine[1]);
    const on = { reach: reach ?? noReach, origin, finish: place(x, y), tool };
    return inDrawing(tableItems(on), origin);
  }, [wanted, motion, reach, finish]);
}

function pointerDown(desk: Desk, event: PointerEvent<HTMLElement>, at: Place, pixel: Place): void {
  if (event.button === 2) return;
  event.currentTarget.focus();
  event.currentTarget.setPointerCapture(event.pointerId);
  desk.set((state) =>
    event.button === 1 ? grabbed(state, pixel) : pressed(state, at, desk.around),
  );
}

/** Keys of the drawing; what they mean nothing to goes on to the page. */
function keyed(desk: Desk, event: KeyboardEvent, unit: LengthUnit): void {
  const key = event.key.toLowerCase();
  const chord = chordOf(key, event, unit);
  if (chord?.(desk.state, desk.around)) {
    event.preventDefault();
    desk.act(chord);
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const meant = desk.waits ? isDeskKey(key) : typed(desk.state, key, desk.around) !== null;
  if (!meant) return;
  event.preventDefault();
  desk.act((state, around) => typed(state, key, around));
}
