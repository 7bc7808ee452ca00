/**
 * Camera of the tool path: a parallel projection, as in a drawing.
 *
 * Machine millimetres. `tilt` 0 looks straight down on the table, 90° from the front; `yaw` turns the
 * table under the viewer. Pure values: a gesture makes a new one.
 */

export type Vec3 = readonly [number, number, number];

export interface Camera {
  /** The place in the middle of the picture, mm. */
  readonly target: Vec3;
  readonly mmPerPixel: number;
  readonly yawRad: number;
  readonly tiltRad: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

export type Aspect = "top" | "front" | "side" | "solid";

const rightAngle = Math.PI / 2;

/** Yaw and tilt of the usual views. */
export const aspects: Record<Aspect, { readonly yawRad: number; readonly tiltRad: number }> = {
  top: { yawRad: 0, tiltRad: 0 },
  front: { yawRad: 0, tiltRad: rightAngle },
  side: { yawRad: rightAngle, tiltRad: rightAngle },
  solid: { yawRad: -Math.PI / 5, tiltRad: Math.PI / 3.2 },
};

/** Between a hair's breadth and a hall to a pixel. */
const nearest = 1e-4;
const farthest = 1e3;

/** Directions in the machine that lie to the right and upwards in the picture. */
export function axesOf(camera: Camera): { right: Vec3; up: Vec3 } {
  const { yawRad, tiltRad } = camera;
  const [sy, cy, st, ct] = [
    Math.sin(yawRad),
    Math.cos(yawRad),
    Math.sin(tiltRad),
    Math.cos(tiltRad),
  ];
  return { right: [cy, sy, 0], up: [-sy * ct, cy * ct, st] };
}

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const along = (from: Vec3, way: Vec3, mm: number): Vec3 => [
  from[0] + way[0] * mm,
  from[1] + way[1] * mm,
  from[2] + way[2] * mm,
];

/** Moves the picture by pixels; `down` counts downwards as pointers do. */
export function pan(camera: Camera, across: number, down: number): Camera {
  const { right, up } = axesOf(camera);
  const target = along(camera.target, right, -across * camera.mmPerPixel);
  return { ...camera, target: along(target, up, down * camera.mmPerPixel) };
}

/** Turns the table under the viewer: half a turn for a way of 500 pixels. */
export function turn(camera: Camera, across: number, down: number): Camera {
  const tiltRad = camera.tiltRad - (down * Math.PI) / 500;
  return {
    ...camera,
    yawRad: camera.yawRad - (across * Math.PI) / 500,
    tiltRad: Math.min(Math.PI, Math.max(0, tiltRad)),
  };
}

/** Zooms so that the place under the pointer stays; the pointer counts from the picture's middle. */
export function zoom(camera: Camera, factor: number, across: number, down: number): Camera {
  const mmPerPixel = Math.min(farthest, Math.max(nearest, camera.mmPerPixel / factor));
  const gone = (camera.mmPerPixel - mmPerPixel) / camera.mmPerPixel;
  return { ...pan(camera, -across * gone, -down * gone), mmPerPixel };
}

/** The corners of a box. */
function corners({ min, max }: Bounds): Vec3[] {
  const pick = (bit: number, axis: 0 | 1 | 2) => (bit ? max[axis] : min[axis]);
  return Array.from({ length: 8 }, (_, n) => [pick(n & 1, 0), pick(n & 2, 1), pick(n & 4, 2)]);
}

/** Extent of points in a direction. */
function reach(points: readonly Vec3[], way: Vec3): number {
  const along = points.map((point) => dot(point, way));
  return Math.max(...along) - Math.min(...along);
}

/** The picture is so many times larger than what is to be in it. */
const usualMargin = 1.15;

/** The whole box in the picture, with a margin. */
export function fit(camera: Camera, bounds: Bounds, size: Size, margin = usualMargin): Camera {
  const { right, up } = axesOf(camera);
  const points = corners(bounds);
  const [width, height] = [Math.max(size.width, 1), Math.max(size.height, 1)];
  const needed = Math.max(reach(points, right) / width, reach(points, up) / height);
  const middle = (axis: 0 | 1 | 2) => (bounds.min[axis] + bounds.max[axis]) / 2;
  return {
    ...camera,
    target: [middle(0), middle(1), middle(2)],
    mmPerPixel: Math.min(farthest, Math.max(nearest, needed * margin)),
  };
}

/** Place in the picture of a place of the machine, pixels from the upper left corner. */
export function project(camera: Camera, place: Vec3, size: Size): { x: number; y: number } {
  const { right, up } = axesOf(camera);
  const away: Vec3 = along(place, camera.target, -1);
  return {
    x: size.width / 2 + dot(away, right) / camera.mmPerPixel,
    y: size.height / 2 - dot(away, up) / camera.mmPerPixel,
  };
}
