/** Hands for tests of the drawing desk. */

import {
  type Around,
  chosen,
  type DeskState,
  type Done,
  dragged,
  escaped,
  firstDesk,
  moved,
  pressed,
  released,
  rightClicked,
  startTool,
  taken,
} from "./desk";
import { shapeOf } from "./geometry/shape";
import { boxOf, place } from "./geometry/vec";
import { typed } from "./keys";
import { pickingOf } from "./pick";
import { tools } from "./tools/catalog";
import { asked, giveNumber } from "./tools/running";
import type { Tool } from "./tools/tool";

export const path = (
  number: number,
  points: readonly number[],
  { closed = false, group = "black" }: { closed?: boolean; group?: string } = {},
) => shapeOf({ number, group, closed, pause: false, z: null, points: [...points] });

export const rectangle = (number: number, x0: number, y0: number, x1: number, y1: number) =>
  path(number, [x0, y0, 0, x1, y0, 0, x1, y1, 0, x0, y1, 0], { closed: true });

export const tool = (id: string): Tool => {
  const found = tools.find((other) => other.id === id);
  if (!found) throw new Error(`no tool ${id}`);
  return found;
};

type Shapes = Parameters<typeof pickingOf>[0];

/** A hand on a desk with shapes: what it did last, and all operations that came of it. */
export class Hand {
  state: DeskState;
  readonly clauses: string[] = [];
  readonly around: Around;

  constructor(shapes: Shapes = [], selected: readonly number[] = [], pickRadius = 8) {
    this.state = { ...firstDesk, size: { width: 200, height: 150 } };
    const box = shapes.reduce(
      (all, { box }) => boxOf(all.min, box.max),
      boxOf(place(0, 0), place(0, 0)),
    );
    this.around = {
      picking: pickingOf(shapes),
      selected,
      picked: [],
      box,
      pickRadius,
      lastJoin: 0.7,
      expansion: 1.05,
    };
  }

  #take({ state, clauses }: Done): this {
    this.state = state;
    if (clauses !== undefined) this.clauses.push(clauses);
    return this;
  }

  begin(id: string): this {
    return this.#take(startTool(this.state, tool(id), this.around));
  }
  move(x: number, y: number): this {
    this.state = moved(this.state, place(x, y), place(0, 0));
    return this;
  }
  click(x: number, y: number, adds = false): this {
    return this.press(x, y).move(x, y).release(adds);
  }
  press(x: number, y: number): this {
    this.state = pressed(this.state, place(x, y), this.around);
    return this;
  }
  release(adds = false): this {
    const { drag } = this.state;
    return this.#take(dragged(released(this.state), drag, adds, this.around));
  }
  /** Chooses a shape among those that a click met. */
  choose(number: number): this {
    const at = this.state.chooser?.at ?? place(0, 0);
    return this.#take(chosen(this.state, number, at, false, this.around));
  }
  drag(x0: number, y0: number, x1: number, y1: number): this {
    return this.press(x0, y0).move(x1, y1).release();
  }
  /** Answers whatever is asked. */
  answer(): this {
    const { running } = this.state;
    const ask = running && asked(running);
    if (!running || !ask) return this;
    if (ask.ask === "shapes") return this.click(10, 5).right();
    if (ask.ask === "shape") return this.click(10, 5);
    if (ask.ask === "region") return this.drag(-5, -5, 50, 50);
    if (ask.ask === "number")
      return this.#take(taken(this.state, giveNumber(running, ask.usual), this.around));
    return this.click(20, 30);
  }
  right(): this {
    return this.#take(rightClicked(this.state, this.around));
  }
  escape(): this {
    return this.#take(escaped(this.state, this.around));
  }
  keys(...names: readonly string[]): this {
    for (const name of names) {
      const done = typed(this.state, name, this.around);
      if (done) this.#take(done);
    }
    return this;
  }
}
