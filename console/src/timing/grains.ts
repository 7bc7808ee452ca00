/**
 * Lines with more points than a chart holds. Of each grain of time they have the first, the least, the
 * greatest and the last point: when what was between is not known, and so not told.
 */

import type { TimingLine } from "../wire/messages";
import { t } from "../words/words";
import { type Box, edgesIn, heightOf, nameOf, type Range, spread, valueAt } from "./course";
import { pixelOf, type Span } from "./span";

type Line = Pick<TimingLine, "kind" | "points" | "grain">;

/** The server rounds moments: one at the end of a grain belongs to the next. */
const slack = 1e-6;

/** The points within the grain of a moment, and where that begins and ends. */
function grainAt({ points, grain }: Line, at: number) {
  const from = Math.floor(at / grain + slack) * grain;
  const within = edgesIn({ points }, { from: from - slack, to: from + grain - 2 * slack });
  return { from, to: from + grain, within };
}

/** The least and the greatest that a line is about a moment: twice the same where that is known. */
export function rangeAt(line: Line, at: number): Range {
  const known: Range = [valueAt(line, at), valueAt(line, at)];
  if (line.grain <= 0) return known;
  const { from, to, within } = grainAt(line, at);
  if (within.length < 2) return known;
  const ends =
    line.kind === "axis" ? [valueAt(line, from), valueAt(line, to)] : [valueAt(line, from - slack)];
  return spread([...ends, ...within.map(([, value]) => value)]);
}

/** Draws a line whose grains are wider than a pixel: bands in which it lies, as a path of an SVG. */
export function bandPath(line: Line, range: Range, span: Span, box: Box): string {
  const { grain } = line;
  const wide = (box.width * grain) / (span.to - span.from);
  if (!(wide > 1)) return "";
  const height = heightOf(range, box);
  let path = "";
  const last = Math.ceil(span.to / grain);
  for (let n = Math.floor(span.from / grain); n < last; n += 1) {
    const [low, high] = rangeAt(line, (n + 0.5) * grain);
    if (low === high || grainAt(line, (n + 0.5) * grain).within.length < 2) continue;
    const [from, to] = [n * grain, (n + 1) * grain].map((at) =>
      pixelOf(span, at, box.width).toFixed(1),
    );
    path += `M${from} ${height(high).toFixed(1)}H${to}V${height(low).toFixed(1)}H${from}Z`;
  }
  return path;
}

/** Words about a chart that has such lines. */
export function grainWords(
  lines: readonly Pick<TimingLine, "kind" | "name" | "grain">[],
): string | undefined {
  const coarse = lines.filter(({ grain }) => grain > 0);
  if (coarse.length === 0) return undefined;
  const each = coarse.map((line) =>
    t("{0} every {1} s", nameOf(line), Number(line.grain.toFixed(3))),
  );
  return t(
    "More happens than a chart holds: only the least and the greatest are shown of {0}.",
    each.join(", "),
  );
}
