/** Finds out if a closed shape crosses itself. */

import Flatbush from "flatbush";
import { meetings, type Segment, segmentBox } from "./segment";
import type { Shape } from "./shape";
import { distance, type Place } from "./vec";

export function crossesItself({ segments, closed }: Shape): boolean {
  if (!closed || segments.length < 3) return false;
  const index = new Flatbush(segments.length);
  const boxes = segments.map(segmentBox);
  for (const { min, max } of boxes) index.add(min.x, min.y, max.x, max.y);
  index.finish();
  return segments.some((segment, n) => {
    const { min, max } = boxes[n] ?? segmentBox(segment);
    const later = index.search(min.x, min.y, max.x, max.y).filter((other) => other > n);
    return later.some((other) => crosses(segment, segments[other]));
  });
}

/** Tells whether two segments meet elsewhere than in an end that they share. */
function crosses(a: Segment, b: Segment | undefined): boolean {
  if (!b) return false;
  return meetings(a, b).some((met) => !(isEnd(met, a) && isEnd(met, b)));
}

const isEnd = (at: Place, { from, to }: Segment): boolean =>
  distance(at, from) < 1e-6 || distance(at, to) < 1e-6;
