import {
  type PointerEvent,
  type ReactNode,
  type RefObject,
  useEffect,
  useMemo,
  useRef,
  useState,
} from "react";
import { useScreen, useSnapshot } from "../../app/context";
import { numberText, placeText } from "../../app/units";
import { useLengthUnit } from "../../app/useLengthUnit";
import { mm } from "../../units/quantity";
import { useSize } from "../../view/useSize";
import type { ZHeights } from "../../wire/messages";
import { t } from "../../words/words";
import { type Place, place } from "../geometry/vec";
import { inkOf, pixelOf } from "../ink";
import { sheetOn } from "../paint/pen";
import type { Scene } from "../scene";
import { boundsOfItems, type Item, itemsOf } from "./items";
import { toolIn } from "./lift";
import { paintItems } from "./paint";
import {
  type Aspect,
  firstSpace,
  keyed,
  lookFrom,
  movedTo,
  pressedAt,
  profile,
  readout,
  releasedAt,
  type Space,
  zoomedAt,
} from "./space";

interface SpaceSheetProps {
  scene: Scene;
  aspect: Aspect;
  /** The z-plane, mm, for the next time that it is looked at so. */
  plane: RefObject<number>;
  children?: ReactNode;
}

const noHeights: ZHeights = { top: mm(0), surface: mm(0), bottom: mm(0) };

/** The drawing from the side, from the end, or in 3D: to be looked at. */
export function SpaceSheet({ scene, aspect, plane, children }: SpaceSheetProps) {
  const box = useRef<HTMLDivElement>(null);
  const size = useSize(box);
  const items = useItems(scene);
  const bounds = useMemo(() => boundsOfItems(items), [items]);
  const [space, setSpace] = useState(() => ({ ...firstSpace, zPlane: plane.current }));
  useEffect(() => {
    plane.current = space.zPlane;
  }, [plane, space.zPlane]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: looks anew from another side, not at every change
  useEffect(() => {
    if (size.width > 0) setSpace((now) => lookFrom({ ...now, size }, aspect, bounds));
  }, [aspect, size.width > 0]);
  useEffect(() => setSpace((now) => ({ ...now, size })), [size]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: keys are heard as soon as a view is chosen
  useEffect(() => box.current?.focus(), [aspect]);
  const at = (event: { clientX: number; clientY: number }) => pixelOf(box.current, event);
  return (
    <section className="sheet-panel" aria-label={t("Sheet")}>
      <div
        ref={box}
        className="sheet-box"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: the view is zoomed with keys
        tabIndex={0}
        role="application"
        aria-label={t("View of the drawing")}
        onKeyDown={(event) => {
          if (event.ctrlKey || event.metaKey || event.altKey) return;
          const next = keyed(space, event.key.toLowerCase(), bounds);
          if (!next) return;
          event.preventDefault();
          setSpace(next);
        }}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          const press = pressOf(event, at(event));
          setSpace((now) => pressedAt(now, press));
        }}
        onPointerMove={(event) => {
          const [id, to] = [event.pointerId, at(event)];
          setSpace((now) => movedTo(now, id, to));
        }}
        onPointerUp={({ pointerId }) => setSpace((now) => releasedAt(now, pointerId))}
        onPointerCancel={({ pointerId }) => setSpace((now) => releasedAt(now, pointerId))}
        onPointerLeave={() => setSpace((now) => ({ ...now, pointer: null }))}
        onContextMenu={(event) => event.preventDefault()}
        onWheel={(event) => {
          const [to, factor] = [at(event), Math.exp(-event.deltaY / 500)];
          setSpace((now) => zoomedAt(now, to, factor));
        }}
      >
        <SpaceCanvas items={items} space={space} />
      </div>
      {children}
      <SpaceStatus space={space} />
    </section>
  );
}

function useItems(scene: Scene): Item[] {
  const drawing = useSnapshot("drawing");
  const heights = useSnapshot("setup")?.heights ?? noHeights;
  const motion = useSnapshot("motion");
  const still = useMemo(
    () => itemsOf(scene, { groups: drawing?.groups ?? [], heights, machine: null }),
    [scene, drawing, heights],
  );
  return useMemo(() => {
    const at = motion && toolIn(motion, heights);
    return at ? [...still, { kind: "machine", at, ink: "--view-tool" }] : still;
  }, [still, motion, heights]);
}

function SpaceCanvas({ items, space }: { items: readonly Item[]; space: Space }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const theme = useScreen("theme");
  const { camera, size } = space;
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme changes the inks
  useEffect(() => {
    const window = { middle: place(0, 0), mmPerPixel: 1 };
    const sheet = canvas.current && sheetOn(canvas.current, window, size);
    if (sheet) paintItems({ pen: sheet.pen, camera, size }, items, inkOf(sheet.pen.canvas));
  }, [items, camera, size, theme]);
  return <canvas ref={canvas} className="sheet-canvas" />;
}

/** Shows the place of the mouse: on the z-plane, or along the side. */
function SpaceStatus({ space }: { space: Space }) {
  const unit = useLengthUnit();
  const text = (value: number) => numberText(mm(value), unit);
  const [flat, side] = [readout(space), profile(space)];
  const across = space.aspect === "side" ? "Y" : "X";
  return (
    <footer className="sheet-status">
      <p className="sheet-status-prompt" role="status">
        <strong>{t("View")}</strong>{" "}
        {space.aspect === "solid"
          ? t("Drag turns, with Shift or the middle button it moves; the wheel zooms.")
          : t("Drag moves, the wheel zooms; both set the z-plane to where the mouse is.")}
      </p>
      <p className="sheet-status-place">
        {flat && placeText([mm(flat.x), mm(flat.y)], unit, 3)}
        {!flat && side && `${across} ${text(side.along)}, Z ${text(side.z)}`}
      </p>
      <p className="sheet-status-plane">{t("z-plane {0} {1}", text(space.zPlane), unit.linear)}</p>
    </footer>
  );
}

const pressOf = (event: PointerEvent, at: Place) => ({
  id: event.pointerId,
  x: at.x,
  y: at.y,
  other: event.button !== 0 || event.shiftKey,
});
