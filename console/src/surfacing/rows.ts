/** The rows of a surfacing program, as its picture shows them. */

export interface Surface {
  readonly width: number;
  readonly height: number;
  readonly bit: number;
  /** Of neighbouring paths, percent of the bit. */
  readonly overlap: number;
}

/** Most rows that a picture shows. */
const most = 40;

/** Places of rows across an area of so much, from its edge: as many as the overlap asks for. */
export function rowsAcross(size: number, { bit, overlap }: Surface): number[] {
  const widest = bit * (1 - overlap / 100);
  const count = Math.min(most, Math.max(1, Math.ceil(size / widest)));
  return Array.from({ length: count }, (_, n) => (size * (n + 0.5)) / count);
}

/** The way of the tool to and fro, as an SVG path with Y down. */
export function zigzag(surface: Surface, alongX: boolean): string {
  const { width, height } = surface;
  const [length, across] = alongX ? [width, height] : [height, width];
  const places = rowsAcross(across, surface).flatMap((row, n) => {
    const ends = n % 2 === 0 ? [0, length] : [length, 0];
    return ends.map((end) => (alongX ? [end, height - row] : [row, height - end]));
  });
  return `M${places.map((place) => place.join(" ")).join("L")}`;
}

/** Rings from the edge to the middle, the cutter within the area. */
export function rings(surface: Surface): string {
  const { width, height, bit, overlap } = surface;
  const step = bit * (1 - overlap / 100);
  let path = "";
  for (let n = 0; n < most; n += 1) {
    const inset = bit / 2 + n * step;
    const [w, h] = [width - 2 * inset, height - 2 * inset];
    if (w < 0 || h < 0) break;
    path += `M${inset} ${inset}h${w}v${h}h${-w}Z`;
  }
  return path;
}
