/**
 * Picture of the sheet as lists: lines with their colours, and small marks. Painters paint them, and tests
 * read them.
 */

import { hueOf, tokenOf } from "./colours";
import { startAngle } from "./geometry/segment";
import type { Shape } from "./geometry/shape";
import { type Box, isEmpty, type Place } from "./geometry/vec";
import type { Scene } from "./scene";

/** A token of the theme. */
export type Token = `--${string}`;

/** A line along a shape. */
export interface Stroke {
  readonly kind: "shape" | "smoothed" | "path" | "rough" | "traversal" | "selected";
  readonly shape: Shape;
  readonly ink: Token;
  readonly dash: boolean;
}

export type Mark =
  /** The bounds of the drawing. */
  | { readonly kind: "bbox"; readonly ink: Token; readonly dash: true; readonly box: Box }
  /** Start of a shape, its direction, and the side on which it is cut. */
  | {
      readonly kind: "start";
      readonly ink: Token;
      readonly at: Place;
      /** Direction of travel, degrees. */
      readonly angle: number;
      readonly side: "left" | "right";
    }
  /** A vertex of a shape. */
  | { readonly kind: "vertex"; readonly ink: Token; readonly at: Place }
  /** A vertex that filtering leaves out. */
  | { readonly kind: "filtered"; readonly ink: Token; readonly at: Place };

export interface Picture {
  /** From the bottom upwards. */
  readonly strokes: readonly Stroke[];
  readonly marks: readonly Mark[];
}

export const pictureOf = (scene: Scene): Picture => {
  const seen = scene.shapes.filter((shape) => !hidden(scene, shape));
  return {
    strokes: [
      ...pathStrokes(scene),
      ...selectedStrokes(scene, seen),
      ...seen.map((shape) => shapeStroke(scene, shape)),
      ...smoothedStrokes(scene),
    ],
    marks: [
      ...boundsMarks(scene),
      ...vertexMarks(scene, seen),
      ...filteredMarks(scene),
      ...startMarks(scene, seen),
    ],
  };
};

/** Tells whether a shape is left out: its group is off, and such groups are not shown. */
export const hidden = (scene: Pick<Scene, "off" | "options">, { group }: Shape): boolean =>
  scene.off.has(group) && !scene.options.offDashed;

export const shapeStroke = ({ off, options, crossing }: Scene, shape: Shape): Stroke => ({
  kind: "shape",
  shape,
  ink: tokenOf(hueOf(shape, options.groupColours, crossing.has(shape.number))),
  dash: off.has(shape.group),
});

const selectedStrokes = ({ selected }: Scene, seen: readonly Shape[]): Stroke[] =>
  seen
    .filter(({ number }) => selected.has(number))
    .map((shape) => ({ kind: "selected", shape, ink: "--draw-selected", dash: false }));

/** The tool's paths; those of rough passes only when they are wanted. */
export const pathStrokes = ({ options, paths }: Scene): Stroke[] =>
  paths
    .filter(({ pass }) => (pass === "rough" ? options.rough : options.toolPaths))
    .map(({ shape, pass }) => ({
      kind: pass === "final" ? "path" : pass,
      shape,
      ink: pass === "rough" ? "--draw-rough" : "--draw-toolpath",
      dash: pass !== "final",
    }));

const smoothedStrokes = ({ options, smoothed }: Scene): Stroke[] =>
  options.smoothed
    ? smoothed.map((shape) => ({ kind: "smoothed", shape, ink: "--draw-smoothed", dash: false }))
    : [];

const boundsMarks = ({ box }: Scene): Mark[] =>
  isEmpty(box) ? [] : [{ kind: "bbox", ink: "--draw-bounds", dash: true, box }];

const vertexMarks = ({ options }: Scene, seen: readonly Shape[]): Mark[] =>
  options.vertices
    ? seen.flatMap(({ vertices }) =>
        vertices.map((at): Mark => ({ kind: "vertex", ink: "--draw-vertex", at })),
      )
    : [];

const filteredMarks = ({ options, filtered }: Scene): Mark[] =>
  options.filtered ? filtered.map((at) => ({ kind: "filtered", ink: "--draw-filtered", at })) : [];

function startMarks({ options, leftOf }: Scene, seen: readonly Shape[]): Mark[] {
  if (!options.starts) return [];
  return seen.flatMap((shape) => {
    const [first] = shape.segments;
    if (!first) return [];
    const angle = (startAngle(first) * 180) / Math.PI;
    const side = leftOf.has(shape.group) ? "left" : "right";
    return [{ kind: "start", ink: "--draw-start", at: first.from, angle, side }];
  });
}
