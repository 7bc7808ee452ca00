import { describe, expect, it } from "vitest";
import { ServerClock } from "./server-clock";

/** Sent and heard by the page's clock, answered by the server's. */
type Ping = readonly [sentMs: number, gotMs: number, serverMs: number];

const ahead = (pings: readonly Ping[]) => {
  const clock = new ServerClock();
  for (const [sent, got, server] of pings) clock.heard(sent, got, server);
  return clock.aheadMs;
};

describe("the server's clock", () => {
  it.each<[string, readonly Ping[], number | null]>([
    ["is unknown before a ping", [], null],
    ["is the middle of a ping", [[0, 100, 5050]], 5000],
    [
      "is that of the fastest way there and the fastest way back",
      [
        [0, 200, 5010],
        [1000, 1200, 6190],
      ],
      5000,
    ],
    [
      "follows a clock that was set",
      [
        [0, 10, 5005],
        [1000, 1010, 9005],
      ],
      8000,
    ],
  ])("%s", (_, pings, expected) => {
    const found = ahead(pings);
    if (expected === null) expect(found).toBeNull();
    else expect(found).toBeCloseTo(expected, 0);
  });
});
