/** The page's end of the picture of a tool path: a canvas whose painter works on a thread of its own. */

import type { Camera, Size } from "../camera";
import type { ToolPath } from "../toolPath";
import type { Order, Told } from "./orders";
import { type Palette, paletteOf } from "./palette";

export class PathScene {
  readonly #canvas = document.createElement("canvas");
  readonly #painter = new Worker(new URL("./painterWorker.ts", import.meta.url), {
    type: "module",
  });

  /** Puts its canvas into an element; `told` hears of every picture. */
  constructor(host: HTMLElement, told: (told: Told) => void) {
    host.append(this.#canvas);
    this.#painter.addEventListener("message", ({ data }: MessageEvent<Told>) => told(data));
    const canvas = this.#canvas.transferControlToOffscreen();
    const ratio = Math.min(devicePixelRatio, 2);
    const begin: Order = { do: "begin", canvas, ratio, palette: paletteOf(host) };
    this.#painter.postMessage(begin, [canvas]);
  }

  /** Takes the colours of the theme over. */
  paint(): Palette {
    const palette = paletteOf(this.#canvas);
    this.#tell({ do: "paint", palette });
    return palette;
  }

  show(path: ToolPath | null): void {
    const coarse = path && { info: path.info, pieces: path.coarse };
    this.#tell({ do: "show", path: coarse, whole: path?.whole ?? null });
  }

  /** Everything before this planned time is made. */
  set now(seconds: number) {
    this.#tell({ do: "now", seconds });
  }

  /** Shows the material that is cut of the path that is shown, or only the path. */
  simulate(on: boolean): void {
    this.#tell({ do: "simulate", on });
  }

  /** Draws jogs, or leaves them out. */
  set jogs(drawn: boolean) {
    this.#tell({ do: "jogs", drawn });
  }

  look(camera: Camera, size: Size): void {
    this.#tell({ do: "look", camera, size });
  }

  dispose(): void {
    this.#painter.terminate();
    this.#canvas.remove();
  }

  #tell(order: Order): void {
    this.#painter.postMessage(order);
  }
}
