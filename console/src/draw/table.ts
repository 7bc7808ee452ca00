/** The job on the machine: bounds, home, origin and finish, in the machine's coordinates. */

import type { Motion, Setup } from "../wire/messages";
import { type Box, minus, type Place, place, plus } from "./geometry/vec";

export type TableItem =
  | { readonly kind: "bounds"; readonly box: Box }
  | { readonly kind: "home" | "origin" | "finish" | "tool"; readonly at: Place };

export interface OnTable {
  /** Distance that X and Y reach from home; 0 is without bounds. */
  readonly reach: Setup["reach"];
  /** Place of the drawing's origin. */
  readonly origin: Place;
  /** Place to which the head goes at the end, from the origin. */
  readonly finish: Place;
  readonly tool: Place | null;
}

/** Place of the drawing's origin: the working zero. */
export function originOf({ at }: Motion): Place {
  const [[x, y], [u, v]] = [at.machine, at.working];
  return place(x - u, y - v);
}

export function tableItems({ reach, origin, finish, tool }: OnTable): TableItem[] {
  const [x, y] = reach;
  const bounds: TableItem[] =
    x > 0 && y > 0 ? [{ kind: "bounds", box: { min: place(0, 0), max: place(x, y) } }] : [];
  return [
    ...bounds,
    { kind: "home", at: place(0, 0) },
    { kind: "origin", at: origin },
    { kind: "finish", at: plus(origin, finish) },
    ...(tool ? [{ kind: "tool" as const, at: tool }] : []),
  ];
}

/** From the machine's coordinates to those of the drawing. */
export const inDrawing = (items: readonly TableItem[], origin: Place): TableItem[] =>
  items.map((item) =>
    item.kind === "bounds"
      ? { ...item, box: { min: minus(item.box.min, origin), max: minus(item.box.max, origin) } }
      : { ...item, at: minus(item.at, origin) },
  );

/** Box that the axes reach, in the drawing; nothing without bounds. */
export function boundsOf(motion: Motion, [x, y]: Setup["reach"]): Box | null {
  const origin = originOf(motion);
  const far = { min: minus(place(0, 0), origin), max: minus(place(x, y), origin) };
  return x > 0 && y > 0 ? far : null;
}
