/** A simplified picture of how far a path is: its cuts from the top, as lines of SVG. */

import type { Size } from "../view/camera";
import { cut } from "../view/piece";
import type { ToolPath } from "../view/toolPath";

export interface Cuts {
  /** Paths of the SVG: the part that is made, and the part that is left. */
  readonly made: string;
  readonly left: string;
  /** Number of segments that are made. */
  readonly count: number;
}

const margin = 6;

/** The cuts of a path, fitted into a picture. */
export function cutsIn(
  { info, coarse }: Pick<ToolPath, "info" | "coarse">,
  size: Size,
  seconds: number,
): Cuts {
  const [low, high] = info.bounds ?? [info.zero, info.zero];
  const [width, height] = [high[0] - low[0], high[1] - low[1]];
  const room = { width: size.width - 2 * margin, height: size.height - 2 * margin };
  const scale = Math.min(room.width / Math.max(width, 1e-9), room.height / Math.max(height, 1e-9));
  const [x0, y0] = [low[0] - info.origin[0], low[1] - info.origin[1]];
  const [dx, dy] = [(size.width - width * scale) / 2, (size.height - height * scale) / 2];
  let [made, left, count] = ["", "", 0];
  for (const { segments, vertices, kinds, over } of coarse) {
    const at = (n: number) => {
      const x = dx + ((vertices[3 * n] ?? 0) - x0) * scale;
      const y = size.height - dy - ((vertices[3 * n + 1] ?? 0) - y0) * scale;
      return `${x.toFixed(1)} ${y.toFixed(1)}`;
    };
    for (let n = 0; n < segments; n += 1) {
      if (kinds[n] !== cut) continue;
      const line = `M${at(n)}L${at(n + 1)}`;
      if ((over[n] ?? 0) <= seconds) {
        made += line;
        count += 1;
      } else left += line;
    }
  }
  return { made, left, count };
}
