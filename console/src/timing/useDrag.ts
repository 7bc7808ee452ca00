import { type PointerEvent, type RefObject, useRef } from "react";

interface DragWishes {
  /** Element from whose left edge pixels count. */
  plot: RefObject<HTMLElement | null>;
  /** A pointer went so far to the right. */
  onPan: (pixels: number) => void;
  /** Two fingers spread by a factor about a pixel. */
  onZoom: (x: number, factor: number) => void;
  /** The pointer is over this pixel, or gone. */
  onAt: (x: number | null) => void;
}

/** Pointers on the chart: one reads it and pans it, two zoom. */
export function useDrag({ plot, onPan, onZoom, onAt }: DragWishes) {
  const down = useRef(new Map<number, number>());
  const xOf = (event: PointerEvent) =>
    event.clientX - (plot.current?.getBoundingClientRect().left ?? 0);
  const lift = (event: PointerEvent) => void down.current.delete(event.pointerId);
  return {
    onPointerDown(event: PointerEvent) {
      event.currentTarget.setPointerCapture(event.pointerId);
      down.current.set(event.pointerId, xOf(event));
      onAt(xOf(event));
    },
    onPointerMove(event: PointerEvent) {
      const x = xOf(event);
      onAt(x < 0 ? null : x);
      const from = down.current.get(event.pointerId);
      if (from === undefined) return;
      const other = [...down.current].find(([id]) => id !== event.pointerId)?.[1];
      down.current.set(event.pointerId, x);
      if (other === undefined) onPan(x - from);
      else onZoom(other, Math.max(Math.abs(x - other), 1) / Math.max(Math.abs(from - other), 1));
    },
    onPointerUp: lift,
    onPointerCancel: lift,
    onPointerLeave: () => onAt(null),
  };
}
