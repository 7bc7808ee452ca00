import type { LengthUnit } from "../units/quantity";
import type { TimingLine } from "../wire/messages";
import { t } from "../words/words";
import { bitWords, coursePath, isBit, labelled, nameOf, rangeOf } from "./course";
import { bandPath } from "./grains";
import { pixelOf, type Span } from "./span";
import { readOf, valueWords } from "./words";

/** Heights of a row with a value and of one with a bit, pixels. */
const [tall, low] = [68, 40];

/** Room of the moment beside an edge, pixels. */
const labelRoom = 46;

interface TimingRowProps {
  line: TimingLine;
  span: Span;
  ticks: readonly number[];
  width: number;
  /** The moment under the pointer. */
  at: number | null;
  unit: LengthUnit;
}

/** One line of the chart with its name. */
export function TimingRow({ line, span, ticks, width, at, unit }: TimingRowProps) {
  const bit = isBit(line);
  const height = bit ? low : tall;
  const range = rangeOf(line);
  const box = { width, top: 16, bottom: height - 5 };
  const path = coursePath(line, range, span, box);
  const read = readOf(line, unit);
  const words = bit
    ? bitWords(line, span)
    : t("{0} from {1} to {2}", nameOf(line), read(range[0]), read(range[1]));
  return (
    <div className="timing-row" data-line={line.name}>
      <span className="timing-name">
        <b title={line.name}>{nameOf(line)}</b>
        <small>{at === null ? about(line, unit) : valueWords(line, at, unit)}</small>
      </span>
      <div className="timing-plot">
        <svg width={width} height={height} role="img" aria-label={words}>
          {ticks.map((tick) => (
            <Upright key={tick} x={pixelOf(span, tick, width)} height={height} look="grid" />
          ))}
          {line.grain > 0 && (
            <path className={`timing-band-${line.kind}`} d={bandPath(line, range, span, box)} />
          )}
          {bit && <path className={`timing-fill-${line.kind}`} d={`${path}V${box.bottom}H0Z`} />}
          <path className={`timing-line timing-${line.kind}`} d={path} />
          {bit &&
            labelled(line, span, width, labelRoom).map(({ x, at, before }) => (
              <text
                key={at}
                x={before ? x - 2 : x + 2}
                y={11}
                textAnchor={before ? "end" : "start"}
              >
                {at.toFixed(3)}
              </text>
            ))}
          {!bit && range[1] > range[0] && <Range width={width} words={range.map(read)} box={box} />}
          {at !== null && <Upright x={pixelOf(span, at, width)} height={height} look="cursor" />}
        </svg>
      </div>
    </div>
  );
}

function Upright({ x, height, look }: { x: number; height: number; look: "grid" | "cursor" }) {
  return <line className={`timing-${look}`} x1={x} x2={x} y1={0} y2={height} />;
}

/** The greatest value above, the least below. */
function Range({
  width,
  words,
  box,
}: {
  width: number;
  words: readonly string[];
  box: { top: number; bottom: number };
}) {
  return (
    <>
      <text className="timing-range" x={width - 3} y={box.top - 5} textAnchor="end">
        {words[1]}
      </text>
      <text className="timing-range" x={width - 3} y={box.bottom - 3} textAnchor="end">
        {words[0]}
      </text>
    </>
  );
}

const about = ({ kind, name }: TimingLine, { linear }: LengthUnit): string => {
  if (kind === "axis") return linear;
  return kind === "value" || name.startsWith(kind) ? "" : kind;
};
