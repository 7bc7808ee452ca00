/**
 * A tool at work: what was answered, what is asked next.
 *
 * Values only: an input gives the next state, and the operations when everything was answered.
 */

import { bulgeThrough } from "../geometry/segment";
import type { Shape } from "../geometry/shape";
import { type Box, distance, type Place } from "../geometry/vec";
import type { SnapKey } from "../snap";
import type { Answer, Ask, Mark, Tool, Vertex } from "./tool";

export interface Running {
  readonly tool: Tool;
  readonly answers: readonly Answer[];
  /** Shapes picked so far, in order. */
  readonly picked: readonly number[];
  /** Vertices of shapes picked so far. */
  readonly marks: readonly Mark[];
  /** Vertices of the path so far. */
  readonly vertices: readonly Vertex[];
  /** The end of an arc whose bulge follows the mouse. */
  readonly bending: Place | null;
  readonly snap: SnapKey | null;
  /** Turn by the arrow keys, degrees. */
  readonly turned: number;
}

/** The next state; nothing when the tool is done or given up. */
export interface Step {
  readonly running: Running | null;
  readonly clauses?: string;
  /** Box that the tool brings into sight. */
  readonly look?: Box;
}

const fresh = (tool: Tool): Running => ({
  tool,
  answers: [],
  picked: [],
  marks: [],
  vertices: [],
  bending: null,
  snap: null,
  turned: 0,
});

/** Begins; a first question for shapes is answered by the shapes that are selected already. */
export function begin(tool: Tool, selected: readonly number[]): Step {
  const running = fresh(tool);
  const first = tool.asks[0];
  if (first?.ask === "shapes" && !first.numbered && selected.length > 0) {
    return answer(running, { kind: "shapes", numbers: selected });
  }
  return settle(running);
}

export const asked = ({ tool, answers }: Running): Ask | undefined => tool.asks[answers.length];

/** The last place that was given, from which `@` counts and G is square. */
export function baseOf({ answers, vertices }: Running): Place | null {
  const vertex = vertices.at(-1);
  if (vertex) return vertex.at;
  const last = answers.at(-1);
  if (last?.kind === "place" || last?.kind === "shape") return last.at;
  return last?.kind === "number" ? baseOf0(answers.slice(0, -1)) : null;
}

function baseOf0(answers: readonly Answer[]): Place | null {
  const last = answers.at(-1);
  return last?.kind === "place" || last?.kind === "shape" ? last.at : null;
}

function answer(running: Running, given: Answer): Step {
  return settle({
    ...running,
    answers: [...running.answers, given],
    picked: [],
    marks: [],
    vertices: [],
    bending: null,
    snap: null,
  });
}

/** Done when nothing is left to ask. A repeating tool asks its last thing again. */
function settle(running: Running): Step {
  const { tool, answers, turned } = running;
  if (answers.length < tool.asks.length) return { running };
  if (tool.look) return { running: null, look: tool.look(answers) };
  const clauses = tool.clauses(answers, turned);
  if (!tool.repeats) return { running: null, clauses };
  return { running: { ...fresh(tool), answers: answers.slice(0, -1) }, clauses };
}

/** A place was given, by the mouse or typed. */
export function givePlace(running: Running, at: Place, shapes: readonly Shape[]): Step {
  const ask = asked(running);
  switch (ask?.ask) {
    case "place":
      return answer(running, { kind: "place", at });
    case "path":
      return extend(running, at, ask.arcs);
    case "number":
      return ask.from ? giveNumber(running, ask.from(at, running.answers, shapes)) : { running };
    default:
      return { running };
  }
}

/** A shape was picked, at a place. Picked again, it is taken out. */
export function giveShape(running: Running, number: number, at: Place): Step {
  switch (asked(running)?.ask) {
    case "shape":
      return answer(running, { kind: "shape", number, at });
    case "shapes": {
      const { picked } = running;
      const without = picked.filter((other) => other !== number);
      const now = without.length < picked.length ? without : [...picked, number];
      return { running: { ...running, picked: now } };
    }
    default:
      return { running };
  }
}

/** Shapes of a region are added to those picked. */
export function giveShapes(running: Running, numbers: readonly number[]): Step {
  const added = numbers.filter((number) => !running.picked.includes(number));
  return { running: { ...running, picked: [...running.picked, ...added] } };
}

/** The shapes whose vertices may be picked: those picked before, or all. */
export function markable({ answers }: Running, shapes: readonly Shape[]): readonly Shape[] {
  const before = answers.find((given) => given.kind === "shapes");
  return before ? shapes.filter(({ number }) => before.numbers.includes(number)) : shapes;
}

/** A vertex was picked. Picked again, it is taken out. */
export function giveMark(running: Running, mark: Mark): Step {
  const without = running.marks.filter((other) => !sameMark(other, mark));
  const taken = without.length < running.marks.length;
  return { running: { ...running, marks: taken ? without : [...running.marks, mark] } };
}

/** Vertices in a window are added to those picked. */
export function giveMarks(running: Running, marks: readonly Mark[]): Step {
  const added = marks.filter((mark) => !running.marks.some((other) => sameMark(other, mark)));
  return { running: { ...running, marks: [...running.marks, ...added] } };
}

const sameMark = (a: Mark, b: Mark): boolean => a.number === b.number && same(a.at, b.at);

export const giveRegion = (running: Running, from: Place, to: Place): Step =>
  asked(running)?.ask === "region" ? answer(running, { kind: "region", from, to }) : { running };

export function giveNumber(running: Running, value: number): Step {
  const ask = asked(running);
  if (ask?.ask !== "number" || ask.accepts?.(value) !== undefined) return { running };
  return answer(running, { kind: "number", value });
}

/** Two places that are one to the eye of whoever snapped to a vertex. */
const same = (a: Place, b: Place): boolean => distance(a, b) < 1e-9;

/** The next vertex: on the first it closes, on the last it ends open. */
function extend(running: Running, at: Place, arcs: boolean): Step {
  const { vertices, bending } = running;
  const [first, last] = [vertices[0], vertices.at(-1)];
  if (bending && last) return bend(running, last, bending, bulgeThrough(last.at, bending, at));
  if (!first || !last) return { running: { ...running, vertices: [{ at, bulge: 0 }], snap: null } };
  if (vertices.length > 1 && same(at, last.at)) return endPath(running, false);
  if (arcs)
    return same(at, last.at) ? { running } : { running: { ...running, bending: at, snap: null } };
  if (vertices.length > 2 && same(at, first.at)) return endPath(running, true);
  if (same(at, last.at)) return { running };
  return { running: { ...running, vertices: [...vertices, { at, bulge: 0 }], snap: null } };
}

/** The bulge of the last segment of a path is known: its end is a vertex, or closes the path. */
function bend(running: Running, last: Vertex, end: Place, bulge: number): Step {
  const first = running.vertices[0];
  const vertices = [...running.vertices.slice(0, -1), { ...last, bulge }];
  const next = { ...running, bending: null, snap: null };
  if (first && vertices.length > 1 && same(end, first.at))
    return endPath({ ...next, vertices }, true);
  return { running: { ...next, vertices: [...vertices, { at: end, bulge: 0 }] } };
}

/** A typed bulge for the segment whose end is given. */
export function giveBulge(running: Running, bulge: number): Step {
  const last = running.vertices.at(-1);
  return running.bending && last ? bend(running, last, running.bending, bulge) : { running };
}

const endPath = (running: Running, closed: boolean): Step =>
  running.vertices.length < 2
    ? { running: null }
    : answer(running, { kind: "path", vertices: running.vertices, closed });

/** The right button, or Enter: finishes what repeats, gives up what a left click would complete. */
export function finish(running: Running): Step {
  const ask = asked(running);
  if (ask?.ask === "path") return endPath({ ...running, bending: null }, false);
  if (ask?.ask === "shapes" && running.picked.length > 0) {
    return answer(running, { kind: "shapes", numbers: running.picked });
  }
  if (ask?.ask === "vertices" && running.marks.length > 0) {
    return answer(running, { kind: "vertices", marks: running.marks });
  }
  return { running: null };
}
