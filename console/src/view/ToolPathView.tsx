import { useEffect, useRef, useState } from "react";
import { useScreen, useSnapshot } from "../app/context";
import { lengthText } from "../app/units";
import type { Units } from "../wire/messages";
import { t } from "../words/words";
import type { Camera, Size } from "./camera";
import { type Marks, paintMarks } from "./overlay";
import type { Told } from "./scene/orders";
import { PathScene } from "./scene/PathScene";
import type { Palette } from "./scene/palette";
import type { Bared } from "./stock";
import type { ToolPath } from "./toolPath";
import "./tool-path-view.css";

interface ToolPathViewProps {
  path: ToolPath | null;
  camera: Camera;
  size: Size;
  /** Planned time up to which everything is made, seconds. */
  now: number;
  marks: Marks;
  /** Shows the material that is cut. */
  stock: boolean;
}

/** The picture: lines below, marks above. */
export function ToolPathView({ path, camera, size, now, marks, stock }: ToolPathViewProps) {
  const lines = useRef<HTMLDivElement>(null);
  const above = useRef<HTMLCanvasElement>(null);
  const { scene, palette, told } = useScene(lines);
  useEffect(() => scene?.show(path), [scene, path]);
  const shape = path?.info;
  // biome-ignore lint/correctness/useExhaustiveDependencies: pieces that arrive change no material
  useEffect(() => scene?.simulate(stock), [scene, stock, shape]);
  useEffect(() => {
    if (scene) scene.now = now;
  }, [scene, now]);
  const { jogs } = marks.typed;
  useEffect(() => {
    if (scene) scene.jogs = jogs;
  }, [scene, jogs]);
  useEffect(() => scene?.look(camera, size), [scene, camera, size]);
  useEffect(() => {
    if (above.current && palette) paintMarks(above.current, size, camera, marks, palette);
  }, [palette, size, camera, marks]);
  const units = useSnapshot("units");
  return (
    <>
      <div
        ref={lines}
        className="path-lines"
        data-path={path ? (told.whole ? "all" : "some") : "none"}
        data-pictures={told.pictures}
        data-bared={told.bared ? baredWords(told.bared) : ""}
        role="img"
        aria-label={describe(path, marks.typed.path.segments, units)}
      />
      <canvas ref={above} className="path-marks" data-typed={marks.typed.path.segments} />
    </>
  );
}

/** The scene of a canvas, painted anew when the theme changes. */
function useScene(host: React.RefObject<HTMLDivElement | null>) {
  const theme = useScreen("theme");
  const [scene, setScene] = useState<PathScene | null>(null);
  const [told, setTold] = useState<Told>({ pictures: 0, whole: false, bared: null });
  const [palette, setPalette] = useState<Palette | null>(null);
  useEffect(() => {
    if (!host.current) return;
    const made = new PathScene(host.current, setTold);
    setScene(made);
    return () => made.dispose();
  }, [host]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme is what changes the colours
  useEffect(() => setPalette(scene?.paint() ?? null), [scene, theme]);
  return { scene, palette, told };
}

/** Square millimetres that are cut, then how wide and deep that is. */
const baredWords = ({ area, min, max }: Bared): string =>
  [area, max[0] - min[0], max[1] - min[1]].map((mm) => mm.toFixed(2)).join(" ");

/** Describes the picture for somebody who does not see it. */
function describe(path: ToolPath | null, typed: number, units: Units | undefined): string {
  if (!path) return typed > 0 ? t("What was typed") : t("No tool path");
  const { moves, cut } = path.info;
  const long = units ? t(", {0} of cuts", lengthText(cut, units, 0)) : "";
  return t("Tool path of {0} moves{1}", moves, long);
}
