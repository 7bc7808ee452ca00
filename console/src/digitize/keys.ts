/** Functions of digitizing, each as the keys of the hand console that call it. */

import type { World } from "../actions/action";
import { drive } from "../actions/ask";
import type { Mm } from "../units/quantity";
import { t } from "../words/words";

export interface DigitizingKey {
  readonly title: string;
  readonly doc: string;
  /** The keys in order: digits, `-` sign, `E` Enter, `F` File, `S` Start, `P` Stop, `U` Func. */
  readonly keys: string;
}

const key = (title: string, keys: string, doc: string): DigitizingKey => ({ title, keys, doc });
const run = (title: string, number: number, doc: string) => key(title, `U${number}E`, doc);

export const begin = run(t("Digitize"), 70, t("Record the points of a shape with the tool"));
export const record = key(
  t("Record"),
  "E",
  t("A point where the tool is, behind the last one (Enter)"),
);
export const kind = key(t("Line / arc"), "-", t("The kind of the next point (+/-)"));

export const steps: readonly DigitizingKey[] = [
  run(t("To start"), 5, t("Along the path to the first point")),
  key(t("Back"), "F", t("To the point before, along its line or arc (File)")),
  key(t("On"), "S", t("To the point behind, along its line or arc (Start)")),
  run(t("To end"), 4, t("Along the path to the last point")),
  run(t("To current"), 6, t("Straight to the current point")),
  run(t("To nearest"), 7, t("Straight to the nearest point, which becomes current")),
];

export const edits: readonly DigitizingKey[] = [
  run(t("Insert after"), 0, t("A point where the tool is, behind the current one")),
  run(t("Insert before"), 1, t("A point where the tool is, before the current one")),
  run(t("Modify"), 3, t("The current point goes where the tool is")),
  run(t("Delete"), 2, t("Takes the current point out")),
];

export const shapes: readonly DigitizingKey[] = [
  run(t("Save open"), 8, t("Adds an open shape to the job or the drawing")),
  run(t("Save closed"), 9, t("Adds a closed shape to the job or the drawing")),
  run(t("Load nearest"), 10, t("The points of the shape nearest to the tool")),
  run(t("Clear"), 15, t("Forgets all points")),
];

export const looks: readonly DigitizingKey[] = [
  run(t("Show points"), 30, t("The points on every sheet")),
  run(t("Show all"), 31, t("All shapes on every sheet")),
  run(t("Show machine"), 32, t("The machine's bounds on every sheet")),
  run(t("Zoom out"), 33, t("Twice as much on every sheet")),
];

export const dimensions = {
  flat: run(t("2D"), 11, t("Shapes without heights")),
  space: run(t("3D"), 12, t("Shapes with the height of each point, without arcs")),
} as const;

export const exit = run(t("Exit"), 99, t("Ends digitizing"));

/** A place that is typed, from the job origin. */
export const moveTo = (x: Mm, y: Mm): DigitizingKey =>
  key(t("Move to"), `U20E${typed(x)}E${typed(y)}E`, t("To a place from the job origin"));

/** A number as keys: File types the point, there is room for nine characters. */
const typed = (length: Mm): string => length.toFixed(3).slice(0, 9).replace(".", "F");

/** Resolves when all earlier presses are done: keys of two buttons must not mix. */
let before: Promise<void> = Promise.resolve();

/** Presses the keys of a button, behind those of the button that was pressed before. */
export function press(world: World, { keys }: DigitizingKey): Promise<void> {
  before = before.then(() => pressed(world, keys));
  return before;
}

/**
 * Presses keys one after the other. None of them moves the tool as an arrow: jogs have numbers above 0, so
 * that a digit which finds no entry open does nothing.
 */
async function pressed(world: World, keys: string): Promise<void> {
  for (const one of keys) {
    const character = one === "E" ? "\r" : one;
    if (!(await drive(world, { do: "key", seq: 0, key: character }))) return;
  }
}
