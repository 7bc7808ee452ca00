import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Act } from "../wire/messages";
import { JogHand, renewEveryMs } from "./jog";
import { directions, wayOfKey } from "./keys";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const wish = { direction: directions.right, speed: 0.3, distance: null };

function hand(lease: number | undefined = 7) {
  const asked: Act[] = [];
  return {
    asked,
    hand: new JogHand(
      (act) => asked.push(act),
      () => lease,
    ),
  };
}

const kinds = (asked: Act[]) => asked.map((act) => act.do);

describe("the dead man's handle", () => {
  it("begins, renews at least every 100 ms, ends", () => {
    const { asked, hand: held } = hand();
    expect(renewEveryMs).toBeLessThanOrEqual(100);
    held.hold(wish);
    vi.advanceTimersByTime(3 * renewEveryMs);
    held.release();
    vi.advanceTimersByTime(1000);
    expect(kinds(asked)).toEqual(["jogStart", "jogRenew", "jogRenew", "jogRenew", "jogStop"]);
    expect(asked[0]).toMatchObject({ lease: 7, seq: 1, direction: [1, 0, 0, 0, 0, 0] });
    expect(asked.at(-1)).toEqual({ do: "jogStop", seq: 1 });
  });

  it("ends the one before with its own number", () => {
    const { asked, hand: held } = hand();
    held.hold(wish);
    held.hold({ ...wish, direction: directions.up });
    expect(kinds(asked)).toEqual(["jogStart", "jogStop", "jogStart"]);
    expect(asked[1]).toMatchObject({ seq: 1 });
    expect(asked[2]).toMatchObject({ seq: 2 });
  });

  it("does nothing without a lease, and is let go twice without harm", () => {
    const { asked, hand: held } = hand();
    held.release();
    const other = new JogHand(
      () => expect.unreachable(),
      () => undefined,
    );
    expect(other.hold(wish)).toBe(false);
    expect(asked).toEqual([]);
  });
});

describe("the keys of the keypad", () => {
  it.each([
    ["ArrowRight", false, [1, 0, 0, 0, 0, 0]],
    ["ArrowDown", false, [0, -1, 0, 0, 0, 0]],
    ["PageUp", false, [0, 0, 1, 0, 0, 0]],
    ["PageUp", true, [0, 0, 0, 1, 0, 0]],
    ["ArrowLeft", true, [-1, 0, 0, 0, 0, 0]],
  ] as const)("%s with Alt %s", (key, alt, direction) => {
    const way = wayOfKey(key, alt);
    expect(way && directions[way]).toEqual(direction);
  });

  it("moves as fast along a diagonal as along an axis", () => {
    const [x, y] = directions[wayOfKey("/", false) ?? "left"];
    expect(Math.hypot(x, y)).toBeCloseTo(1);
    expect([x, y].every((part) => part > 0)).toBe(true);
    const [ax, ay] = directions[wayOfKey("/", true) ?? "right"];
    expect([ax, ay]).toEqual([-x, -y]);
  });

  it("means nothing else", () => expect(wayOfKey("a", false)).toBeUndefined());
});
