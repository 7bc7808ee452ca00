/**
 * Tools of the desk, as data.
 *
 * A tool asks a few things in order: shapes, places, numbers. When all are given it is a text of
 * drawing operations, the same that `kerf draw --do` reads. Nothing else changes a drawing.
 */

import type { Segment } from "../geometry/segment";
import type { Shape } from "../geometry/shape";
import type { Box, Place } from "../geometry/vec";

/** A vertex that is being drawn; the bulge belongs to the segment behind it. */
export interface Vertex {
  readonly at: Place;
  readonly bulge: number;
}

export type Ask =
  /** Any number of shapes, in the order of picking; the right button finishes. */
  | { readonly ask: "shapes"; readonly prompt: string; readonly numbered?: boolean }
  /** One shape, by a place on it. */
  | { readonly ask: "shape"; readonly prompt: string }
  /** Any number of vertices, one by one or in a window, of the shapes picked before if there are any. */
  | { readonly ask: "vertices"; readonly prompt: string }
  | { readonly ask: "place"; readonly prompt: string }
  /** A line of places, or of arcs, until it is closed or finished. */
  | { readonly ask: "path"; readonly prompt: string; readonly arcs: boolean }
  | { readonly ask: "region"; readonly prompt: string }
  | {
      readonly ask: "number";
      readonly prompt: string;
      readonly kind: "length" | "angle" | "plain";
      /** Taken when nothing is typed. */
      readonly usual: number;
      readonly accepts?: (value: number) => string | undefined;
      /** The number that a place means, where the mouse may give it. */
      readonly from?: (at: Place, before: readonly Answer[], shapes: readonly Shape[]) => number;
    };

/** A vertex of a shape that is there. */
export interface Mark {
  readonly number: number;
  readonly at: Place;
}

export type Answer =
  | { readonly kind: "shapes"; readonly numbers: readonly number[] }
  | { readonly kind: "shape"; readonly number: number; readonly at: Place }
  | { readonly kind: "vertices"; readonly marks: readonly Mark[] }
  | { readonly kind: "place"; readonly at: Place }
  | { readonly kind: "path"; readonly vertices: readonly Vertex[]; readonly closed: boolean }
  | { readonly kind: "region"; readonly from: Place; readonly to: Place }
  | { readonly kind: "number"; readonly value: number };

/** Drawing of a change before it is made. */
export type Ghost =
  | { readonly kind: "none" }
  | { readonly kind: "segments"; readonly segments: readonly Segment[] }
  | { readonly kind: "moved"; readonly numbers: readonly number[]; readonly by: Matrix };

/** x' = a x + c y + e, y' = b x + d y + f, as a canvas takes it. */
export type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

export const noGhost: Ghost = { kind: "none" };

export type Menu = "insert" | "edit" | "arrange" | "path" | "sequence" | "view";

export interface Tool {
  readonly id: string;
  readonly title: string;
  /** One sentence for a person. */
  readonly doc: string;
  readonly menu: Menu;
  readonly key?: string;
  readonly asks: readonly Ask[];
  /** The operations, when everything was answered. `turned` is what the arrow keys added, degrees. */
  readonly clauses: (answers: readonly Answer[], turned: number) => string;
  /** Changes what is in sight instead of the drawing. */
  readonly look?: (answers: readonly Answer[]) => Box;
  /** Arrow keys turn what is being moved. */
  readonly turns?: boolean;
  /** Asks the last thing again after every change. */
  readonly repeats?: boolean;
  readonly ghost?: (
    answers: readonly Answer[],
    at: Place,
    turned: number,
    shapes: readonly Shape[],
  ) => Ghost;
}

/** A number as operations read it: no exponent, and exact. */
export const num = (value: number): string => {
  const text = String(value);
  return text.includes("e") ? value.toFixed(12) : text;
};
export const xy = ({ x, y }: Place): string => `${num(x)},${num(y)}`;

const kindOf = <K extends Answer["kind"]>(answer: Answer | undefined, kind: K) =>
  answer?.kind === kind ? (answer as Extract<Answer, { kind: K }>) : undefined;

const missing = (what: string): never => {
  throw new Error(`a tool was asked for its operations without ${what}`);
};

export const numbersOf = (answer: Answer | undefined): readonly number[] =>
  kindOf(answer, "shapes")?.numbers ?? missing("shapes");
export const placeOf = (answer: Answer | undefined): Place =>
  kindOf(answer, "place")?.at ?? missing("a place");
export const amountOf = (answer: Answer | undefined): number =>
  kindOf(answer, "number")?.value ?? missing("a number");
export const shapeAt = (answer: Answer | undefined) =>
  kindOf(answer, "shape") ?? missing("a shape");
export const marksOf = (answer: Answer | undefined): readonly Mark[] =>
  kindOf(answer, "vertices")?.marks ?? missing("vertices");
export const pathOf = (answer: Answer | undefined) => kindOf(answer, "path") ?? missing("a path");
export const regionOf = (answer: Answer | undefined) =>
  kindOf(answer, "region") ?? missing("a region");

export const select = (numbers: readonly number[]): string => `select ${numbers.join(",")}`;
