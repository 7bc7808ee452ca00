/** The stretch of time that a chart shows, and what moves it. Seconds everywhere. */

export interface Span {
  readonly from: number;
  readonly to: number;
}

/** The shortest stretch that is shown: a pulse of a pierce is longer. */
const least = 0.001;

const clamped = (value: number, low: number, high: number): number =>
  Math.min(Math.max(value, low), Math.max(low, high));

/** All of a run. */
export const whole = (end: number): Span => ({ from: 0, to: Math.max(end, least) });

/** Shows `factor` times as much detail about a moment, which stays where it is. */
export function zoomed(span: Span, at: number, factor: number, end: number): Span {
  const all = whole(end);
  const wide = clamped((span.to - span.from) / factor, least, all.to);
  const share = (at - span.from) / (span.to - span.from);
  return held({ from: at - share * wide, to: at + (1 - share) * wide }, all);
}

/** Goes later by a share of what is shown; earlier when it is negative. */
export function panned(span: Span, share: number, end: number): Span {
  const by = (span.to - span.from) * share;
  return held({ from: span.from + by, to: span.to + by }, whole(end));
}

/** The same stretch of a run that has another end; all of it stays all of it. */
export function fitted(span: Span, before: number, end: number): Span {
  const isAll = span.to - span.from >= whole(before).to;
  return isAll ? whole(end) : zoomed(span, span.from, 1, end);
}

/** The same length within all there is. */
function held({ from, to }: Span, all: Span): Span {
  const start = clamped(from, all.from, all.to - (to - from));
  return { from: start, to: start + (to - from) };
}

/** Pixel at which a moment is drawn on a chart of that width. */
export const pixelOf = (span: Span, at: number, width: number): number =>
  ((at - span.from) / (span.to - span.from)) * width;

/** The moment at a pixel. */
export const momentOf = (span: Span, x: number, width: number): number =>
  span.from + (x / Math.max(width, 1)) * (span.to - span.from);

/** Round moments so far apart that their numbers have room, and their decimals. */
export function ticksOf(span: Span, width: number): { at: readonly number[]; decimals: number } {
  const room = ((span.to - span.from) * 72) / Math.max(width, 72);
  const power = 10 ** Math.floor(Math.log10(room));
  const step = ([1, 2, 5].find((n) => n * power >= room) ?? 10) * power;
  const first = Math.ceil(span.from / step - 1e-9);
  const count = Math.floor(span.to / step + 1e-9) - first + 1;
  const at = Array.from({ length: Math.max(count, 0) }, (_, n) => (first + n) * step);
  return { at, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}
