import { type KeyboardEvent, useEffect, useMemo, useRef } from "react";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import { useSize } from "../view/useSize";
import type { Timing } from "../wire/messages";
import { t } from "../words/words";
import { grainWords } from "./grains";
import { all, closer, cursorOfKey, earlier, further, later, moveOfKey } from "./keys";
import { momentOf, panned, pixelOf, type Span, ticksOf, zoomed } from "./span";
import { TimingRow } from "./TimingRow";
import { useCursor, useFocusAtFirst, useSpan } from "./useChart";
import { useDrag } from "./useDrag";
import { endWords, momentWords, secondsText } from "./words";

/** The chart: lines under one another, time along them. */
export function TimingChart({ timing, busy }: { timing: Timing; busy: boolean }) {
  const end = timing.seconds;
  const [span, setSpan] = useSpan(end);
  const { at, told, point, step } = useCursor();
  const plot = useRef<HTMLDivElement>(null);
  const { width } = useSize(plot);
  const unit = useLengthUnit();
  const ticks = useMemo(() => ticksOf(span, width), [span, width]);
  const chart = useWheel(plot, (at, detail, sideways) =>
    setSpan((now) =>
      sideways === 0
        ? zoomed(now, momentOf(now, at, width), detail, end)
        : panned(now, sideways / Math.max(width, 1), end),
    ),
  );
  const drag = useDrag({
    plot,
    onPan: (pixels) => setSpan((now) => panned(now, -pixels / Math.max(width, 1), end)),
    onZoom: (x, factor) => setSpan((now) => zoomed(now, momentOf(now, x, width), factor, end)),
    onAt: (x) => point(x === null ? null : momentOf(span, x, width)),
  });
  const hear = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const cursor = event.shiftKey ? cursorOfKey(event.key) : undefined;
    const move = cursor ? undefined : moveOfKey(event.key);
    if (!cursor && !move) return;
    event.preventDefault();
    event.stopPropagation();
    if (cursor) step(cursor(at, span));
    if (move) setSpan((now) => move(now, end));
  };
  useFocusAtFirst(chart);
  const notes = [grainWords(timing.lines), endWords(timing)].filter((words) => words !== undefined);
  const rest = { span, ticks: ticks.at, width, at, unit };
  return (
    <>
      <TimingBar span={span} end={end} at={at} onSpan={setSpan} />
      {/* biome-ignore lint/a11y/useSemanticElements: a group of drawn lines that hears keys */}
      <div
        ref={chart}
        className="timing-chart"
        role="group"
        aria-label={t("Timing chart")}
        aria-busy={busy}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: its keys are heard while it has the focus
        tabIndex={0}
        data-from={span.from}
        data-to={span.to}
        onKeyDown={hear}
        {...drag}
      >
        {timing.lines.map((line) => (
          <TimingRow key={`${line.kind} ${line.name}`} line={line} {...rest} />
        ))}
        <div className="timing-row timing-foot">
          <span className="timing-name">s</span>
          <div ref={plot} className="timing-plot">
            <TimeAxis span={span} ticks={ticks} width={width} />
          </div>
        </div>
      </div>
      <p className="timing-told hidden-text" role="status">
        {told && at !== null ? momentWords(timing.lines, at, unit) : ""}
      </p>
      {notes.map((words) => (
        <p key={words} className="timing-note">
          {words}
        </p>
      ))}
    </>
  );
}

interface TimingBarProps {
  span: Span;
  end: number;
  at: number | null;
  onSpan: (change: (span: Span) => Span) => void;
}

const buttons = [
  { words: "◀", name: t("Earlier"), move: earlier },
  { words: "▶", name: t("Later"), move: later },
  { words: "+", name: t("More detail"), move: closer },
  { words: "−", name: t("Less detail"), move: further },
  { words: "All", name: t("All of it"), move: all },
] as const;

/** Buttons that move the time, and the stretch that is shown. */
function TimingBar({ span, end, at, onSpan }: TimingBarProps) {
  return (
    <div className="timing-bar" role="toolbar" aria-label={t("Time")}>
      {buttons.map(({ words, name, move }) => (
        <Button
          key={name}
          size="small"
          aria-label={name}
          onPress={() => onSpan((now) => move(now, end))}
        >
          {words}
        </Button>
      ))}
      <span className="timing-span">
        {at === null
          ? `${secondsText(span.from)} … ${secondsText(span.to)}`
          : t("at {0}", secondsText(at))}
      </span>
    </div>
  );
}

interface TimeAxisProps {
  span: Span;
  ticks: { at: readonly number[]; decimals: number };
  width: number;
}

function TimeAxis({ span, ticks, width }: TimeAxisProps) {
  return (
    <svg width={width} height={22} aria-hidden="true">
      {ticks.at.map((at) => {
        const x = pixelOf(span, at, width);
        const anchor = x < 20 ? "start" : x > width - 20 ? "end" : "middle";
        return (
          <text key={at} x={x} y={15} textAnchor={anchor}>
            {at.toFixed(ticks.decimals)}
          </text>
        );
      })}
    </svg>
  );
}

/** The wheel: more or less detail about the pointer, sideways or with Shift earlier and later. */
function useWheel(
  plot: { current: HTMLElement | null },
  turn: (x: number, detail: number, sideways: number) => void,
) {
  const chart = useRef<HTMLDivElement>(null);
  const latest = useRef(turn);
  latest.current = turn;
  useEffect(() => {
    const box = chart.current;
    const hear = (event: WheelEvent) => {
      event.preventDefault();
      const left = plot.current?.getBoundingClientRect().left ?? 0;
      const across = event.shiftKey ? event.deltaX + event.deltaY : event.deltaX;
      const sideways = event.shiftKey || Math.abs(across) > Math.abs(event.deltaY) ? across : 0;
      latest.current(event.clientX - left, Math.exp(-event.deltaY / 500), sideways);
    };
    // The sheet must not scroll meanwhile.
    box?.addEventListener("wheel", hear, { passive: false });
    return () => box?.removeEventListener("wheel", hear);
  }, [plot]);
  return chart;
}
