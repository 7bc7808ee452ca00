import { describe, expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import { fold } from "./fold";

describe("changes of the snapshot", () => {
  it("replace a section and leave the others the same objects", () => {
    const overrides = { feedPercent: 80 };
    const next = fold(firstSnapshot, { change: "overrides", overrides });
    expect(next.overrides).toBe(overrides);
    expect(next.motion).toBe(firstSnapshot.motion);
    expect(next).not.toHaveProperty("change");
    expect(next.revision).toBe(firstSnapshot.revision + 1);
  });

  it("empty a section", () =>
    expect(fold(firstSnapshot, { change: "opened", opened: null }).opened).toBeNull());

  it("add to the print window, which keeps its last lines", () => {
    let now = firstSnapshot;
    for (let n = 0; n < 1005; n += 1) now = fold(now, { change: "printed", lines: [`${n}`] });
    expect(now.printed).toHaveLength(1000);
    expect(now.printed[0]).toBe("5");
    expect(fold(now, { change: "clearPrinted" }).printed).toEqual([]);
  });
});
