import { useLengthUnit } from "../app/useLengthUnit";
import { t } from "../words/words";
import { heightText, type Place, shareOf } from "./heights";

/** Most places along a side whose numbers can be read. */
const readable = 9;

const width = 320;

/** The colour of a share of the range: blue is low, red is high. */
const colour = (share: number): string =>
  `color-mix(in hsl increasing hue, var(--height-high) ${100 * share}%, var(--height-low))`;

/** A grid of heights as coloured fields with numbers, as they lie on the table. */
export function HeightPicture({ places }: { places: readonly Place[] }) {
  const unit = useLengthUnit();
  const [xs, ys] = ([0, 1] as const).map((axis) => distinct(places, axis)) as [number[], number[]];
  const zs = places.map(([, , z]) => z);
  const [lowest, highest] = [Math.min(...zs), Math.max(...zs)];
  const [w, h] = [width / Math.max(1, xs.length), 26];
  const numbers = xs.length <= readable;
  return (
    <svg
      className="height-map-picture"
      viewBox={`0 0 ${width} ${h * Math.max(1, ys.length)}`}
      role="img"
      aria-label={t("Heights of the surface")}
    >
      {places.map(([x, y, z]) => {
        const [left, top] = [xs.indexOf(x) * w, (ys.length - 1 - ys.indexOf(y)) * h];
        return (
          <g key={`${x} ${y}`}>
            <rect
              x={left}
              y={top}
              width={w}
              height={h}
              style={{ fill: colour(shareOf(z, lowest, highest)) }}
            />
            {numbers && (
              <text x={left + w / 2} y={top + h / 2}>
                {heightText(z, unit)}
              </text>
            )}
          </g>
        );
      })}
    </svg>
  );
}

/** The values of an axis, each once, in order. */
const distinct = (places: readonly Place[], axis: 0 | 1): number[] =>
  [...new Set<number>(places.map((place) => place[axis]))].sort((a, b) => a - b);
