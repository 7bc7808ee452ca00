/**
 * The drawing seen from the side, from the end, or in 3D: the camera, and the z-plane on which the mouse
 * lies. Hands move the camera as they do that of the tool path.
 */

import {
  axesOf,
  type Bounds,
  type Camera,
  dot,
  fit as fitted,
  pan,
  type Size,
  type Vec3,
  zoom,
} from "../../view/camera";
import { type Gesture, moved, noGesture, type Press, pressed, released } from "../../view/gestures";
import { type Place, place } from "../geometry/vec";

export type Aspect = "top" | "side" | "end" | "solid";

/** Side: Y to the right; end: X to the right; in both Z upwards. 3D: all axes equally long. */
const ways: Record<Aspect, Pick<Camera, "yawRad" | "tiltRad">> = {
  top: { yawRad: 0, tiltRad: 0 },
  side: { yawRad: Math.PI / 2, tiltRad: Math.PI / 2 },
  end: { yawRad: 0, tiltRad: Math.PI / 2 },
  solid: { yawRad: -Math.PI / 4, tiltRad: Math.acos(1 / Math.sqrt(3)) },
};

export interface Space {
  readonly aspect: Aspect;
  readonly camera: Camera;
  readonly size: Size;
  readonly gesture: Gesture;
  /** The z-plane in which places under the mouse lie, mm. */
  readonly zPlane: number;
  /** The mouse, pixels. */
  readonly pointer: Place | null;
}

export const firstSpace: Space = {
  aspect: "solid",
  camera: { target: [0, 0, 0], mmPerPixel: 1, ...ways.solid },
  size: { width: 0, height: 0 },
  gesture: noGesture,
  zPlane: 0,
  pointer: null,
};

/** Looks from another side, at everything. */
export const lookFrom = (space: Space, aspect: Aspect, bounds: Bounds): Space => ({
  ...space,
  aspect,
  camera: fitted({ ...space.camera, ...ways[aspect] }, bounds, space.size),
});

export const middleOf = ({ width, height }: Size): Place => place(width / 2, height / 2);

/** The place of the picture's plane under a pixel. */
function under({ camera, size }: Space, { x, y }: Place): Vec3 {
  const { right, up } = axesOf(camera);
  const across = (x - size.width / 2) * camera.mmPerPixel;
  const upwards = (size.height / 2 - y) * camera.mmPerPixel;
  const sum = (axis: 0 | 1 | 2) => camera.target[axis] + right[axis] * across + up[axis] * upwards;
  return [sum(0), sum(1), sum(2)];
}

/** Directions whose share of Z is smaller look along the planes. */
const level = 1e-6;

/** X and Y of the mouse on the z-plane; nothing where the plane is seen from its edge. */
export function readout(space: Space): Place | null {
  if (!space.pointer) return null;
  const { right, up } = axesOf(space.camera);
  const towards: Vec3 = [
    right[1] * up[2] - right[2] * up[1],
    right[2] * up[0] - right[0] * up[2],
    right[0] * up[1] - right[1] * up[0],
  ];
  if (Math.abs(towards[2]) < level) return null;
  const at = under(space, space.pointer);
  const far = (space.zPlane - at[2]) / towards[2];
  return place(at[0] + towards[0] * far, at[1] + towards[1] * far);
}

/** Place of the mouse along the picture's two axes of the drawing, in a view from the side or end. */
export function profile(space: Space): { readonly along: number; readonly z: number } | null {
  if (!space.pointer || !isProfile(space)) return null;
  const at = under(space, space.pointer);
  return { along: dot(axesOf(space.camera).right, at), z: at[2] };
}

const isProfile = ({ aspect }: Space): boolean => aspect === "side" || aspect === "end";

/** Panning and zooming in a view from the side or end set the z-plane to where the hand is. */
const planeAt = (space: Space, pixel: Place): Space =>
  isProfile(space) ? { ...space, zPlane: under(space, pixel)[2] } : space;

export const pressedAt = (space: Space, press: Press): Space => {
  const gesture = pressed(space.gesture, press, space.aspect !== "solid");
  const next = { ...space, gesture };
  return gesture.kind === "pan" ? planeAt(next, place(press.x, press.y)) : next;
};

export const movedTo = (space: Space, id: number, to: Place): Space => ({
  ...space,
  ...moved(space.gesture, space.camera, id, to, middleOf(space.size)),
  pointer: to,
});

export const releasedAt = (space: Space, id: number): Space => ({
  ...space,
  gesture: released(space.gesture, id),
});

/** Zooms so that what is under a pixel stays there. */
export function zoomedAt(space: Space, pixel: Place, factor: number): Space {
  const { x, y } = middleOf(space.size);
  return planeAt({ ...space, camera: zoom(space.camera, factor, pixel.x - x, pixel.y - y) }, pixel);
}

/** Half or double the window, with what is under a pixel in the middle (Z and X). */
export function zoomedTo(space: Space, pixel: Place, factor: number): Space {
  const centred = centredOn(space, pixel);
  return { ...centred, camera: zoom(centred.camera, factor, 0, 0) };
}

/** Moves the place under a pixel into the middle of the window, at the same size (S). */
export function centredOn(space: Space, pixel: Place): Space {
  const { x, y } = middleOf(space.size);
  return { ...planeAt(space, pixel), camera: pan(space.camera, x - pixel.x, y - pixel.y) };
}

/** A key without modifiers; nothing when it means nothing here. */
export function keyed(space: Space, key: string, bounds: Bounds): Space | null {
  const at = space.pointer ?? middleOf(space.size);
  switch (key) {
    case "z":
      return zoomedTo(space, at, 2);
    case "x":
      return zoomedTo(space, at, 0.5);
    case "s":
      return centredOn(space, at);
    case "a":
      return lookFrom(space, space.aspect, bounds);
    default:
      return null;
  }
}
