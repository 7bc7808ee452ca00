import { describe, expect, it } from "vitest";
import { millimetres, seconds } from "../units/quantity";
import type { Finding, Timing, TimingLine } from "../wire/messages";
import { bitWords, coursePath, labelled, rangeOf, valueAt } from "./course";
import { bandPath, grainWords, rangeAt } from "./grains";
import { cursorOfKey, moveOfKey } from "./keys";
import { fitted, momentOf, panned, pixelOf, ticksOf, whole, zoomed } from "./span";
import { endWords, momentWords } from "./words";

const router: TimingLine = {
  kind: "output",
  name: "router",
  grain: 0,
  points: [
    [2, 1],
    [6, 0],
  ],
};
const z: TimingLine = {
  kind: "axis",
  name: "z",
  grain: 0,
  points: [
    [1, 0],
    [3, -20],
    [5, -20],
  ],
};
const beam: TimingLine = {
  kind: "value",
  name: "intensity",
  grain: 0,
  points: [
    [2, 64],
    [6, 0],
  ],
};
const box = { width: 100, top: 10, bottom: 30 };

describe("the span", () => {
  it("zooms about a moment, which stays where it is", () => {
    const span = zoomed(whole(10), 4, 2, 10);
    expect(span).toEqual({ from: 2, to: 7 });
    expect(pixelOf(span, 4, 100)).toBe(40);
    expect(momentOf(span, 40, 100)).toBe(4);
  });

  it("never leaves the run", () => {
    expect(zoomed({ from: 2, to: 7 }, 4, 0.01, 10)).toEqual({ from: 0, to: 10 });
    expect(panned({ from: 2, to: 7 }, 9, 10)).toEqual({ from: 5, to: 10 });
    expect(panned({ from: 2, to: 7 }, -9, 10)).toEqual({ from: 0, to: 5 });
    const closest = zoomed(whole(10), 10, 1e9, 10);
    expect(closest.to - closest.from).toBeCloseTo(0.001, 9);
  });

  it("has keys", () => {
    const press = (key: string) => moveOfKey(key)?.({ from: 2, to: 6 }, 10);
    expect(press("ArrowRight")).toEqual({ from: 3, to: 7 });
    expect(press("End")).toEqual({ from: 6, to: 10 });
    expect(press("Home")).toEqual({ from: 0, to: 4 });
    expect(press("0")).toEqual({ from: 0, to: 10 });
    expect(press("k")).toBeUndefined();
  });

  it("stays when the run has another end, as far as there is so much of it", () => {
    expect(fitted(whole(10), 10, 4)).toEqual(whole(4));
    expect(fitted({ from: 2, to: 4 }, 10, 8)).toEqual({ from: 2, to: 4 });
    expect(fitted({ from: 6, to: 8 }, 10, 7)).toEqual({ from: 5, to: 7 });
    expect(fitted({ from: 2, to: 9 }, 10, 4)).toEqual(whole(4));
  });

  it("has a cursor that keys move within it", () => {
    const press = (key: string, at: number | null) => cursorOfKey(key)?.(at, { from: 2, to: 7 });
    expect(press("ArrowRight", null)).toBe(4.5);
    expect(press("ArrowRight", 4.5)).toBeCloseTo(4.6, 9);
    expect(press("ArrowLeft", 2.05)).toBe(2);
    expect(press("Home", 3)).toBeUndefined();
  });

  it("is marked at round moments that have room", () => {
    expect(ticksOf(whole(10), 720)).toEqual({
      at: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
      decimals: 0,
    });
    expect(ticksOf({ from: 0.31, to: 0.61 }, 216)).toMatchObject({ decimals: 1 });
    expect(ticksOf(whole(0), 500).at.length).toBeGreaterThan(1);
    expect(ticksOf(whole(3600), 300).at.length).toBeLessThan(6);
  });
});

describe("a line", () => {
  it("of a bit goes up and down at its edges", () => {
    const path = coursePath(router, [0, 1], whole(10), box);
    expect(path).toBe("M0.0 30.0L20.0 30.0L20.0 10.0L60.0 10.0L60.0 30.0L100.0 30.0");
    const within = coursePath(router, [0, 1], { from: 3, to: 5 }, box);
    const begins = coursePath(
      {
        ...router,
        points: [
          [0, 1],
          [10, 0],
        ],
      },
      [0, 1],
      whole(10),
      box,
    );
    expect(begins, "edges at both ends").toBe(
      "M0.0 30.0L0.0 30.0L0.0 10.0L100.0 10.0L100.0 30.0L100.0 30.0",
    );
    expect(within, "on from before the span until behind it").toBe("M0.0 10.0L100.0 10.0");
  });

  it("of an axis rests before its first point and behind its last", () => {
    const path = coursePath(z, [-20, 0], whole(10), box);
    expect(path).toBe("M0.0 10.0L10.0 10.0L30.0 30.0L50.0 30.0L100.0 30.0");
  });

  it("of very many points keeps their peaks and not their number", () => {
    const points = Array.from({ length: 20_000 }, (_, n): [number, number] => [
      n / 2000,
      n === 12_345 ? 50 : n % 2,
    ]);
    const path = coursePath({ kind: "axis", points }, [0, 50], whole(10), box);
    expect(path.split("L").length).toBeLessThan(450);
    expect(path).toContain(" 10.0");
  });

  it("of a value holds each until the next, and is 0 before", () => {
    const path = coursePath(beam, rangeOf(beam), whole(10), box);
    expect(path).toBe("M0.0 30.0L20.0 30.0L20.0 10.0L60.0 10.0L60.0 30.0L100.0 30.0");
    expect([1.9, 2, 5.9, 6, 9].map((at) => valueAt(beam, at))).toEqual([0, 64, 64, 0, 0]);
  });

  it("by grains is drawn as bands and read as a range, where it has more than a point in one", () => {
    const coarse: TimingLine = {
      ...beam,
      grain: 2,
      points: [
        [2, 64],
        [2.1, 0],
        [3.9, 64],
        [5, 0],
      ],
    };
    expect(rangeAt(coarse, 3)).toEqual([0, 64]);
    expect([1, 4.5, 5.5].map((at) => rangeAt(coarse, at))).toEqual([
      [0, 0],
      [64, 64],
      [0, 0],
    ]);
    expect(bandPath(coarse, [0, 64], whole(10), box)).toBe("M20.0 10.0H40.0V30.0H20.0Z");
    expect(bandPath(coarse, [0, 64], whole(1000), box), "narrower than a pixel").toBe("");
    expect(grainWords([router, coarse])).toContain("of intensity every 2 s");
    expect(grainWords([{ ...z, grain: 0.32 }])).toContain("of Z every 0.32 s");
    expect(grainWords([router])).toBeUndefined();
    const axis: TimingLine = { ...coarse, kind: "axis" };
    expect(rangeAt(axis, 3)).toEqual([0, 64]);
    expect(rangeAt(axis, 4.45)[0]).toBeCloseTo(32, 9);
  });

  it("has a value at every moment", () => {
    expect([1.9, 2, 5.9, 6].map((at) => valueAt(router, at))).toEqual([0, 1, 1, 0]);
    expect([0, 1, 2, 4, 9].map((at) => valueAt(z, at))).toEqual([0, 0, -10, -20, -20]);
    expect(valueAt({ kind: "axis", points: [] }, 1)).toBe(0);
  });

  it("tells its edges in words, and beside them where there is room", () => {
    expect(bitWords(router, whole(10))).toBe("router: on 2.000 s, off 6.000 s");
    expect(bitWords(router, { from: 3, to: 5 })).toBe("router is on all the time");
    expect(bitWords(router, { from: 3, to: 7 })).toBe("router: on at 3.000 s, off 6.000 s");
    const before: TimingLine = { ...router, points: [[0, 1], ...router.points.slice(1)] };
    expect(bitWords(before, whole(10))).toBe("router: on from the beginning, off 6.000 s");
    expect(labelled(router, whole(10), 400, 46).map(({ at }) => at)).toEqual([2, 6]);
    expect(
      labelled(router, whole(10), 100, 46).map(({ at }) => at),
      "one hides the other",
    ).toEqual([2]);
  });
});

describe("the words of a chart", () => {
  const timing: Timing = {
    seconds: seconds(4),
    whole: true,
    full: false,
    status: "ok",
    finding: null,
    lines: [z, router],
  };

  it("tell everything at a moment", () => {
    expect(momentWords(timing.lines, 2, millimetres)).toBe("At 2.000 s: Z -10.00 mm, router on");
  });

  it("tell why it ends before the run does", () => {
    expect(endWords(timing)).toBeUndefined();
    const failed = { ...timing, whole: false, status: "failed" };
    expect(endWords(failed)).toBe("It ends at 4.000 s: it failed");
    const finding = { message: "division by zero", line: 3 } as Finding;
    expect(endWords({ ...failed, finding })).toBe("It ends at 4.000 s: division by zero (line 3)");
    expect(endWords({ ...timing, whole: false, full: true })).toContain("more often");
  });
});
