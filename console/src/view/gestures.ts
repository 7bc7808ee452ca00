/**
 * Gestures of pointers on the picture: one turns or pans it, two pan and zoom.
 *
 * A gesture is a value; a movement of a pointer gives the next one and the change of the camera.
 */

import { type Camera, pan, turn, zoom } from "./camera";

interface At {
  readonly x: number;
  readonly y: number;
}

export type Gesture =
  | { readonly kind: "none" }
  | { readonly kind: "pan" | "turn"; readonly id: number; readonly at: At }
  | {
      readonly kind: "pinch";
      readonly ids: readonly [number, number];
      readonly at: readonly [At, At];
    };

export interface Press extends At {
  readonly id: number;
  /** The middle or right button, or Shift: pans where the left one turns. */
  readonly other: boolean;
}

export const noGesture: Gesture = { kind: "none" };

/** A flat view is panned by any button; only a solid one turns. */
export function pressed(gesture: Gesture, press: Press, flat: boolean): Gesture {
  if (gesture.kind === "pinch") return gesture;
  if (gesture.kind !== "none") {
    return { kind: "pinch", ids: [gesture.id, press.id], at: [gesture.at, press] };
  }
  return { kind: flat || press.other ? "pan" : "turn", id: press.id, at: press };
}

export interface Moved {
  readonly gesture: Gesture;
  readonly camera: Camera;
}

/** The picture's middle, from which zooming counts. */
export function moved(gesture: Gesture, camera: Camera, id: number, to: At, middle: At): Moved {
  if (gesture.kind === "none") return { gesture, camera };
  if (gesture.kind === "pinch") return pinched(gesture, camera, id, to, middle);
  if (gesture.id !== id) return { gesture, camera };
  const change = gesture.kind === "pan" ? pan : turn;
  return {
    gesture: { ...gesture, at: to },
    camera: change(camera, to.x - gesture.at.x, to.y - gesture.at.y),
  };
}

const distance = (a: At, b: At): number => Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1);
const between = (a: At, b: At): At => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });

function pinched(
  gesture: Extract<Gesture, { kind: "pinch" }>,
  camera: Camera,
  id: number,
  to: At,
  middle: At,
): Moved {
  const [a, b] = gesture.at;
  const at: [At, At] = [id === gesture.ids[0] ? to : a, id === gesture.ids[1] ? to : b];
  const [before, after] = [between(a, b), between(...at)];
  const shifted = pan(camera, after.x - before.x, after.y - before.y);
  const factor = distance(...at) / distance(a, b);
  return {
    gesture: { ...gesture, at },
    camera: zoom(shifted, factor, after.x - middle.x, after.y - middle.y),
  };
}

/** A pointer is gone; the one that is left goes on panning. */
export function released(gesture: Gesture, id: number): Gesture {
  if (gesture.kind === "pinch" && gesture.ids.includes(id)) {
    const left = gesture.ids[0] === id ? 1 : 0;
    return { kind: "pan", id: gesture.ids[left], at: gesture.at[left] };
  }
  return gesture.kind !== "none" && gesture.kind !== "pinch" && gesture.id === id
    ? noGesture
    : gesture;
}
