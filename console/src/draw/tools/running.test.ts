import { describe, expect, it } from "vitest";
import { place } from "../geometry/vec";
import { tools } from "./catalog";
import {
  begin,
  finish,
  giveBulge,
  giveNumber,
  givePlace,
  giveShape,
  type Running,
} from "./running";
import { larger, smaller, turnedOn, wrapped } from "./turn";

/** Input of a hand: a click, a key, a typed value. */
type Input =
  | { at: [number, number] }
  | { shape: number; on?: [number, number] }
  | { number: number }
  | { bulge: number }
  | "right";

function step(running: Running, input: Input) {
  if (input === "right") return finish(running);
  if ("at" in input) return givePlace(running, place(...input.at), []);
  if ("shape" in input) return giveShape(running, input.shape, place(...(input.on ?? [0, 0])));
  if ("bulge" in input) return giveBulge(running, input.bulge);
  return giveNumber(running, input.number);
}

/** The operations that a tool makes of what a hand does. */
function made(
  id: string,
  inputs: readonly Input[],
  selected: readonly number[] = [],
): string | null {
  const tool = tools.find((other) => other.id === id);
  if (!tool) throw new Error(`no tool ${id}`);
  let { running, clauses } = begin(tool, selected);
  for (const input of inputs) {
    if (!running) return clauses ?? null;
    ({ running, clauses } = step(running, input));
  }
  return clauses ?? null;
}

describe("tools make operations of clicks", () => {
  it.each<[string, readonly Input[], string | null]>([
    ["circle", [{ at: [50, 50] }, { at: [75, 50] }], "circle 50,50 25"],
    ["circle", [{ at: [50, 50] }, { number: -1 }], null],
    ["rectangle", [{ at: [10, 10] }, { at: [60, 40] }], "rect 10,10 60,40"],
    ["point", [{ at: [5, 5] }], "point 5,5"],
    ["line", [{ at: [0, 0] }, { at: [10, 0] }, { at: [10, 10] }, "right"], "line 0,0 10,0 10,10"],
    ["line", [{ at: [0, 0] }, "right"], null],
    [
      "line",
      [{ at: [0, 0] }, { at: [100, 0] }, { at: [100, 100] }, { at: [0, 0] }],
      "line 0,0 100,0 100,100 close",
    ],
    ["line", [{ at: [0, 0] }, { at: [10, 0] }, { at: [10, 0] }], "line 0,0 10,0"],
    ["polyarc", [{ at: [0, 0] }, { at: [10, 0] }, { at: [5, -5] }, "right"], "line 0,0,1 10,0"],
    [
      "polyarc",
      [{ at: [0, 0] }, { at: [10, 0] }, { bulge: 0.414214 }, "right"],
      "line 0,0,0.414214 10,0",
    ],
    [
      "polyarc",
      [{ at: [25, 0] }, { at: [-25, 0] }, { bulge: 1 }, { at: [25, 0] }, { bulge: 1 }],
      "line 25,0,1 -25,0,1 close",
    ],
    [
      "move",
      [{ shape: 1 }, { shape: 2 }, "right", { at: [0, 0] }, { at: [210, 110] }],
      "select 1,2; move from 0,0 to 210,110",
    ],
    ["move", [{ shape: 1 }, "right", { at: [0, 0] }, "right"], null],
    ["erase", [{ shape: 1 }, { shape: 2 }, { shape: 1 }, "right"], "select 2; erase"],
    ["start", [{ shape: 4, on: [50, 0] }], "start 4 50,0"],
    ["sequence", [{ shape: 3 }, { shape: 1 }, "right"], "sequence 3,1"],
    ["sequence-level", [{ shape: 3 }, { shape: 1 }, "right"], "sequence level 3,1"],
    ["sequence-groups", [{ shape: 4 }, { shape: 1 }, "right"], "sequence groups of 4,1"],
    ["paste-absolute", [{ at: [100, 0] }], "paste absolute 100,0"],
    [
      "rotate-to",
      [{ shape: 2 }, "right", { at: [0, 0] }, { at: [100, 100] }, { number: 90 }],
      "select 2; rotate to 90 from 0,0 100,100",
    ],
    // The mouse points in the direction, or at the length.
    [
      "rotate-to",
      [{ shape: 2 }, "right", { at: [5, 0] }, { at: [9, 9] }, { at: [2, 0] }],
      "select 2; rotate to 180 from 5,0 9,9",
    ],
    [
      "scale-to",
      [{ shape: 2 }, "right", { at: [1, 1] }, { at: [51, 1] }, { at: [31, 41] }],
      "select 2; scale to 50 from 1,1 51,1",
    ],
    ["scale-to", [{ shape: 2 }, "right", { at: [0, 0] }, { at: [9, 0] }, { number: -2 }], null],
    ["directions", [], "directions auto"],
    ["fillet", [{ number: 3 }, { shape: 2, on: [9, 9] }], "select 2; fillet 3 at 9,9"],
  ])("%s %j → %s", (id, inputs, clauses) => {
    expect(made(id, inputs)).toBe(clauses);
  });

  it("acts on what is selected already", () => {
    expect(made("erase", [], [3, 5])).toBe("select 3,5; erase");
    expect(made("sequence", [{ shape: 2 }, "right"], [3, 5])).toBe("sequence 2");
  });

  it("asks the last thing again where a tool repeats", () => {
    const tool = tools.find(({ id }) => id === "fillet");
    if (!tool) throw new Error("no fillet");
    const { running } = giveNumber(begin(tool, []).running as Running, 3);
    const again = giveShape(running as Running, 1, place(0, 0));
    expect(again.running?.answers).toEqual([{ kind: "number", value: 3 }]);
  });

  it("has tools with a word of their own", () => {
    expect(new Set(tools.map(({ id }) => id)).size).toBe(tools.length);
  });
});

describe("arrow keys turn", () => {
  it("steps up to 90 and down to 1 degrees", () => {
    const ups = [1, 2, 4, 8, 15, 30, 45, 60, 75, 90];
    expect(ups.map(larger)).toEqual([2, 4, 8, 15, 30, 45, 60, 75, 90, 90]);
    expect(ups.map(smaller)).toEqual([1, 1, 2, 4, 8, 15, 30, 45, 60, 75]);
  });

  it("keeps to multiples from 15 degrees on", () => {
    const presses = (step: number, count: number, from = 0, way: 1 | -1 = 1) =>
      Array.from({ length: count }).reduce<number[]>(
        (all) => [...all, turnedOn(all.at(-1) ?? from, step, way)],
        [],
      );
    expect(presses(1, 3)).toEqual([1, 2, 3]);
    expect(presses(60, 6).map(wrapped)).toEqual([60, 120, 180, 240, 300, 0]);
    expect(presses(75, 5).map(wrapped)).toEqual([75, 150, 225, 300, 15]);
    expect(presses(15, 1, 8)).toEqual([15]);
    expect(presses(15, 1, 8, -1)).toEqual([0]);
    expect(presses(1, 1, 0, -1).map(wrapped)).toEqual([359]);
  });
});
