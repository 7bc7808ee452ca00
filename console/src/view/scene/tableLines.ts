/** The table with its grid, and the working axes. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  LineBasicMaterial,
  LineSegments,
} from "three";
import type { PreviewInfo } from "../../wire/messages";
import type { Palette } from "./palette";

/** Most lines of a grid in one direction; a finer grid is left out. */
const mostLines = 400;

const segmentsOf = (points: readonly number[], material: LineBasicMaterial): LineSegments => {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  return lines;
};

/** Lines of the grid across the table, from the origin of the preview. */
export function gridPoints(info: PreviewInfo): number[] {
  const [x0, y0] = [info.table[0] - info.origin[0], info.table[1] - info.origin[1]];
  const [width, depth] = info.tableSize;
  const z = info.zero[2] - info.origin[2];
  const steps = (length: number) => Math.min(Math.floor(length / info.grid), mostLines);
  const points: number[] = [];
  for (let n = 0; n <= steps(width); n += 1) {
    points.push(x0 + n * info.grid, y0, z, x0 + n * info.grid, y0 + depth, z);
  }
  for (let n = 0; n <= steps(depth); n += 1) {
    points.push(x0, y0 + n * info.grid, z, x0 + width, y0 + n * info.grid, z);
  }
  return points;
}

/** The edge of the table and the working axes. */
export function framePoints(info: PreviewInfo): number[] {
  const [x0, y0] = [info.table[0] - info.origin[0], info.table[1] - info.origin[1]];
  const [x1, y1] = [x0 + info.tableSize[0], y0 + info.tableSize[1]];
  const [zx, zy, z] = [
    info.zero[0] - info.origin[0],
    info.zero[1] - info.origin[1],
    info.zero[2] - info.origin[2],
  ];
  const edge = [
    x0,
    y0,
    z,
    x1,
    y0,
    z,
    x1,
    y0,
    z,
    x1,
    y1,
    z,
    x1,
    y1,
    z,
    x0,
    y1,
    z,
    x0,
    y1,
    z,
    x0,
    y0,
    z,
  ];
  return [...edge, zx, y0, z, zx, y1, z, x0, zy, z, x1, zy, z];
}

export class TableLines {
  readonly group = new Group();
  readonly #grid = new LineBasicMaterial({ depthWrite: false });
  readonly #frame = new LineBasicMaterial({ depthWrite: false });

  show(info: PreviewInfo): void {
    for (const child of this.group.children) {
      if (child instanceof LineSegments) child.geometry.dispose();
    }
    this.group.clear();
    if (info.grid > 0) this.group.add(segmentsOf(gridPoints(info), this.#grid));
    this.group.add(segmentsOf(framePoints(info), this.#frame));
  }

  paint(palette: Palette): void {
    this.#grid.color = new Color(palette.grid);
    this.#frame.color = new Color(palette.axis);
  }
}
