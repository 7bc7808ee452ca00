import { useEffect, useMemo, useRef } from "react";
import { useHands, useScreen, useShown, useSnapshot } from "../app/context";
import { useDisplay } from "../app/display";
import { timeOfMoves } from "../view/place";
import { paletteOf } from "../view/scene/palette";
import { useSize } from "../view/useSize";
import { useToolPath } from "../view/useToolPath";
import { t } from "../words/words";
import "./progress-picture.css";
import { Panel } from "../ui/Panel";
import { movesMade } from "./fileStatus";
import { cutsIn } from "./progressPicture";

/** The path done so far, small and from the top (VD); a right click leads to its settings. */
export function ProgressPicture() {
  const wanted = useDisplay()?.progress;
  const face = useScreen("face");
  return wanted && face === "full" ? <Picture /> : null;
}

function Picture() {
  const { screen } = useHands();
  const preview = useSnapshot("opened")?.preview;
  const path = useToolPath(preview?.state === "ready" ? preview.key : undefined);
  const made = useShown(movesMade);
  const theme = useScreen("theme");
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = useSize(box);
  const seconds = path ? timeOfMoves(path.coarse, made) : 0;
  const lines = useMemo(() => path && cutsIn(path, size, seconds), [path, size, seconds]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the theme is what changes the colours
  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen || !canvas.current) return;
    Object.assign(canvas.current, { width: size.width, height: size.height });
    const { cut, done } = paletteOf(canvas.current);
    for (const [path, ink, width] of [
      [lines?.left, cut, 0.5],
      [lines?.made, done, 2],
    ] as const) {
      pen.strokeStyle = ink;
      pen.lineWidth = width;
      if (path) pen.stroke(new Path2D(path));
    }
  }, [lines, size, theme]);
  const settings = () => screen.open({ kind: "command", letters: "VD", given: [] });
  return (
    <Panel
      title="Done so far"
      className="progress-picture"
      aside={
        <button type="button" className="status-change" onClick={settings}>
          VD
        </button>
      }
    >
      {/* biome-ignore lint/a11y/noStaticElementInteractions: the button above does the same by key */}
      <div
        ref={box}
        className="progress-box"
        onContextMenu={(event) => {
          event.preventDefault();
          settings();
        }}
      >
        <canvas
          ref={canvas}
          role="img"
          aria-label={t("{0} pieces of the path are cut", lines?.count ?? 0)}
        />
      </div>
    </Panel>
  );
}
