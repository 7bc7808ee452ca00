import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Act, Problem } from "../wire/messages";
import { JogHand, renewEveryMs } from "./jog";
import { directions, wayOfKey } from "./keys";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** The server's clock: a thousand ahead of this page's. */
const clockMs = (): number | null => Date.now() + 1000;

const wish = { direction: directions.right, speedShare: 0.3, distance: null };

/** A hand whose requests are kept; starts are refused as often as there are problems. */
function hand(problems: Problem[] = [], lease: number | null = 7, clock = () => clockMs()) {
  const asked: Act[] = [];
  const refused: string[] = [];
  const ask = async (act: Act) => {
    asked.push(act);
    const problem = act.do === "jogStart" ? (problems.shift() ?? null) : null;
    return { id: 0, problem, notes: [] };
  };
  const held = new JogHand(
    ask,
    () => lease ?? undefined,
    clock,
    (why) => refused.push(why),
  );
  return { asked, refused, held, kinds: () => asked.map((act) => act.do) };
}

const clockOf = (act: Act | undefined) => (act && "clockMs" in act ? act.clockMs : undefined);

const seqOf = (act: Act | undefined) => (act && "seq" in act ? act.seq : undefined);

describe("the dead man's handle", () => {
  it("never uses a number twice, whichever hand of a page it is", () => {
    const [one, other] = [hand(), hand()];
    one.held.hold(wish);
    one.held.release();
    other.held.press("8");
    other.held.release();
    expect(seqOf(other.asked[0])).toBeGreaterThan(seqOf(one.asked[0]) ?? 0);
    expect(other.asked[0]).toMatchObject({ do: "key", key: "8" });
  });

  it("begins, renews at least every 100 ms, ends", async () => {
    const { asked, held, kinds } = hand();
    expect(renewEveryMs).toBeLessThanOrEqual(100);
    held.hold(wish);
    await vi.advanceTimersByTimeAsync(3 * renewEveryMs);
    held.release();
    await vi.advanceTimersByTimeAsync(1000);
    expect(kinds()).toEqual(["jogStart", "jogRenew", "jogRenew", "jogRenew", "jogStop"]);
    const [begun] = asked;
    expect(begun).toMatchObject({ lease: 7, direction: [1, 0, 0, 0, 0, 0] });
    expect(asked.at(-1)).toEqual({ do: "jogStop", seq: seqOf(begun) });
  });

  it("says with every sign when it held the key, on the server's clock", async () => {
    const { asked, held } = hand();
    const begun = Date.now() + 1000;
    held.hold(wish);
    await vi.advanceTimersByTimeAsync(2 * renewEveryMs);
    held.release();
    const signs = asked.filter((act) => act.do !== "jogStop").map(clockOf);
    expect(signs).toEqual([begun, begun + renewEveryMs, begun + 2 * renewEveryMs]);
  });

  it("holds nothing before the link was measured", () => {
    const { asked, held, refused } = hand([], 7, () => null);
    held.hold(wish);
    held.release();
    expect(asked).toEqual([]);
    expect(refused).toEqual(["The link is being measured: press the key again in a moment."]);
  });

  it("ends the one before with its own number", () => {
    const { asked, held, kinds } = hand();
    held.hold(wish);
    held.hold({ ...wish, direction: directions.up });
    expect(kinds()).toEqual(["jogStart", "jogStop", "jogStart"]);
    expect(seqOf(asked[1])).toBe(seqOf(asked[0]));
    expect(seqOf(asked[2])).toBe((seqOf(asked[0]) ?? 0) + 1);
  });

  it("begins again while the one before ramps down, as long as it is held", async () => {
    const busy: Problem = { why: "state", text: "another jog is not over yet" };
    const { held, kinds, refused } = hand([busy, busy]);
    held.hold(wish);
    await vi.advanceTimersByTimeAsync(2.5 * renewEveryMs);
    expect(kinds().filter((kind) => kind === "jogStart")).toHaveLength(3);
    expect(refused).toEqual([]);
    held.release();
  });

  it("does not begin again once it is let go", async () => {
    const { held, kinds } = hand([{ why: "state", text: "busy" }]);
    held.hold(wish);
    await vi.advanceTimersByTimeAsync(1);
    held.release();
    await vi.advanceTimersByTimeAsync(1000);
    expect(kinds()).toEqual(["jogStart"]);
  });

  it("tells why it is refused and stops renewing", async () => {
    const { held, kinds, refused } = hand([{ why: "lease", text: "somebody else drives" }]);
    held.hold(wish);
    await vi.advanceTimersByTimeAsync(1000);
    expect(refused).toEqual(["somebody else drives"]);
    expect(kinds()).toEqual(["jogStart"]);
  });

  it("does nothing without a lease, and is let go twice without harm", () => {
    const { asked, held } = hand([], null);
    held.release();
    held.hold(wish);
    held.release();
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
